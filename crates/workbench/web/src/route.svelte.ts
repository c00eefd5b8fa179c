/** The view in the address: `#live`, `#program/FB20/n8`, `#watch/dosing.watch`, `#symbols`, `#cpu`. */
export const VIEWS = ['live', 'program', 'watch', 'symbols', 'cpu'] as const;
export type View = (typeof VIEWS)[number];

class Route {
  view = $state<View>('live');
  rest = $state.raw<string[]>([]);

  start(): void {
    this.#read();
    addEventListener('hashchange', () => this.#read());
  }

  #read(): void {
    const [view = '', ...rest] = location.hash.replace(/^#\/?/, '').split('/').map(decodeURIComponent);
    this.view = VIEWS.find((name) => name === view) ?? 'live';
    this.rest = rest;
  }

  go(view: View, ...rest: string[]): void {
    const wanted = `#${[view, ...rest.map(encodeURIComponent)].join('/')}`;
    if (location.hash !== wanted) location.hash = wanted;
  }
}
export const route = new Route();
