/** Light, dark, high contrast: kept, at first as the browser prefers. */
const THEMES = ['light', 'dark', 'hc'] as const;
type Name = (typeof THEMES)[number];

class Theme {
  name = $state<Name>('light');

  start(): void {
    const kept = new URLSearchParams(location.search).get('theme') ?? localStorage.getItem('theme');
    this.name = THEMES.find((one) => one === kept) ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
    document.documentElement.dataset['theme'] = this.name;
    const zoom = Number(new URLSearchParams(location.search).get('zoom'));
    if (zoom >= 0.5 && zoom <= 3) this.#enlarge(zoom);
  }

  /** Everything larger, for a projector: what holds for a width holds for that much more of it. */
  #enlarge(zoom: number): void {
    document.documentElement.style.zoom = String(zoom);
    const done = new WeakSet<CSSStyleSheet>();
    const scale = () => {
      for (const sheet of document.styleSheets) {
        if (done.has(sheet)) continue;
        done.add(sheet);
        for (const rule of sheet.cssRules) if (rule instanceof CSSMediaRule) rule.media.mediaText = rule.media.mediaText.replace(/([\d.]+)px/g, (_, px) => `${Number(px) * zoom}px`);
      }
    };
    addEventListener('load', scale);
    // Views bring theirs when they are opened.
    new MutationObserver((all) => {
      for (const node of all.flatMap((one) => [...one.addedNodes])) if (node instanceof HTMLLinkElement) node.addEventListener('load', scale);
    }).observe(document.head, { childList: true });
  }

  next(): void {
    this.name = THEMES[(THEMES.indexOf(this.name) + 1) % THEMES.length] ?? 'light';
    document.documentElement.dataset['theme'] = this.name;
    localStorage.setItem('theme', this.name);
  }
}
export const theme = new Theme();
