// A picture in a panel of its own: an SVG that can do nothing but be looked at.
import * as vscode from 'vscode';

/** The HTML of a picture. Scripts and addresses in it have no effect: it is an image, and the page allows nothing else. */
export function html(svg: string, title: string, dark: boolean, size: 'as it is' | 'fitting' = 'as it is'): string {
  // The picture follows the theme of the editor, not that of the system.
  const themed = svg.replaceAll('@media(prefers-color-scheme:dark)', dark ? '@media all' : '@media not all');
  const data = Buffer.from(themed, 'utf8').toString('base64');
  const nonce = crypto.randomUUID().replaceAll('-', '');
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'nonce-${nonce}'">
<title>${escaped(title)}</title>
<style nonce="${nonce}">body{padding:12px}img{max-width:${size === 'fitting' ? '100%' : 'none'}}p{color:var(--vscode-descriptionForeground)}</style>
</head>
<body>${svg === '' ? `<p>${escaped(title)}</p>` : `<img alt="${escaped(title)}" src="data:image/svg+xml;base64,${data}">`}</body>
</html>
`;
}

/** Whether the theme of this moment is dark. */
export const isDark = (): boolean => [vscode.ColorThemeKind.Dark, vscode.ColorThemeKind.HighContrast].includes(vscode.window.activeColorTheme.kind);

const escaped = (text: string): string => text.replace(/[&<>"']/gu, (sign) => `&#${sign.charCodeAt(0)};`);
