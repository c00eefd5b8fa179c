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
    if (zoom >= 0.5 && zoom <= 3) document.documentElement.style.zoom = String(zoom);
  }

  next(): void {
    this.name = THEMES[(THEMES.indexOf(this.name) + 1) % THEMES.length] ?? 'light';
    document.documentElement.dataset['theme'] = this.name;
    localStorage.setItem('theme', this.name);
  }
}
export const theme = new Theme();
