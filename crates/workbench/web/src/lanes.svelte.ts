/** Signals over time as the page knows them: where each became another value, asked for piece by piece. */
import { page } from './state.svelte';

/** Scans that are kept of what came live. */
const KEEP = 12_000;
const POINTS = 2000;

export class Lanes {
  /** For each channel where it changed: scan, value. */
  points = $state.raw<Record<string, [number, number][]>>({});
  /** Scans with their times; those between are on lines between them. */
  #times = $state.raw<[number, number][]>([]);
  /** What is known: from, to. */
  from = $state(0);
  to = $state(-1);
  #asking = false;
  #channels: string[] = [];
  #hash = '';

  /** Completes what is known to a window. */
  async cover(channels: string[], from: number, to: number): Promise<void> {
    if (this.#asking || channels.length === 0 || page.link !== 'up' || to < 0) return;
    const known = channels.join() === this.#channels.join() && this.#hash === page.programHash && this.to <= page.newest;
    const a = Math.max(page.oldest, from, to - KEEP / 2);
    let ask: [number, number];
    if (!known || this.to < 0 || a > this.to + 1) ask = [a, to];
    else if (a < this.from) ask = [a, this.from - 1];
    else if (to > this.to) ask = [this.to + 1, to];
    else return;
    if (ask[1] < ask[0]) return;
    this.#asking = true;
    try {
      const got = await page.history(ask[0], ask[1], channels, POINTS);
      // Each channel begins with the value that it had: without one no scan of these is kept yet.
      if (got === null || Object.values(got.channels).every((points) => points.length === 0)) return;
      // The newest scans may not be kept yet: what is known ends where the answer does.
      const end = Math.min(ask[1], got.to);
      const before = known && this.to >= 0 && ask[0] <= this.to + 1;
      const next: Record<string, [number, number][]> = {};
      for (const name of channels) {
        const fresh = got.channels[name] ?? [];
        const old = before ? (this.points[name] ?? []) : [];
        const all = ask[0] < this.from && before ? [...fresh, ...old] : [...old, ...fresh];
        next[name] = all.filter(([, value], i) => i === 0 || all[i - 1]?.[1] !== value);
      }
      if (before) {
        this.from = Math.min(this.from, ask[0]);
        this.to = Math.max(this.to, end);
      } else [this.from, this.to] = [ask[0], end];
      const times = before ? [...this.#times, ...got.times].sort((one, other) => one[0] - other[0]) : got.times;
      this.#times = times.filter(([scan], i) => scan !== times[i - 1]?.[0]);
      if (this.to - this.from > KEEP) {
        this.from = this.to - KEEP / 2;
        for (const name of channels) next[name] = cut(next[name] ?? [], this.from);
      }
      if ((this.#times[0]?.[0] ?? 0) < this.from) this.#times = cut(this.#times, this.from);
      this.#channels = channels;
      this.#hash = page.programHash;
      this.points = next;
    } finally {
      this.#asking = false;
    }
  }

  /** When a scan was, in microseconds of the CPU. */
  us(scan: number): number {
    return between(this.#anchored(), 0, scan, page.scanUs);
  }

  /** The scan of a time; between two scans a fraction. */
  scan(us: number): number {
    return between(this.#anchored(), 1, us, 1 / page.scanUs);
  }

  /** What is not known yet is as far from the newest scan as scans in their cycle are. */
  #anchored(): [number, number][] {
    const times = this.#times;
    return page.newest > (times.at(-1)?.[0] ?? -1) ? [...times, [page.newest, page.newestUs]] : times;
  }

  /** The value of a channel in a scan, if it is known. */
  at(name: string, scan: number): number | undefined {
    return valueAt(this.points[name] ?? [], scan);
  }
}

/** The other coordinate of a line through points, for one that has this; outside of them the line goes on with a slope. */
function between(points: [number, number][], by: 0 | 1, at: number, slope: number): number {
  let low = 0;
  let high = points.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((points[middle]?.[by] ?? Infinity) <= at) low = middle + 1;
    else high = middle;
  }
  const [a, b] = [points[low - 1], points[low]];
  const to = by === 0 ? 1 : 0;
  if (a !== undefined && b !== undefined) return a[to] + ((at - a[by]) / (b[by] - a[by])) * (b[to] - a[to]);
  const one = a ?? b;
  return one === undefined ? 0 : one[to] + (at - one[by]) * slope;
}

/** Drops what is older, and keeps the value that held then. */
function cut(points: [number, number][], from: number): [number, number][] {
  let i = 0;
  while (i + 1 < points.length && (points[i + 1]?.[0] ?? Infinity) <= from) i += 1;
  return points.slice(i);
}

export function valueAt(points: [number, number][], scan: number): number | undefined {
  let low = 0;
  let high = points.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((points[middle]?.[0] ?? Infinity) <= scan) low = middle + 1;
    else high = middle;
  }
  return points[low - 1]?.[1];
}

/** A step line of a channel between two scans: path of the line, of the area below. */
export function stepPath(points: [number, number][], from: number, to: number, x: (scan: number) => number, y: (value: number) => number, base: number): { line: string; area: string } {
  const start = valueAt(points, from);
  const inside = points.filter(([scan]) => scan > from && scan <= to);
  const first = start === undefined ? inside.shift() : ([from, start] as [number, number]);
  if (first === undefined) return { line: '', area: '' };
  const x0 = x(Math.max(from, first[0])).toFixed(1);
  let line = `M${x0} ${y(first[1]).toFixed(1)}`;
  let area = `M${x0} ${base}V${y(first[1]).toFixed(1)}`;
  for (const [scan, value] of inside) {
    const piece = `H${x(scan).toFixed(1)}V${y(value).toFixed(1)}`;
    line += piece;
    area += piece;
  }
  const end = `H${x(to).toFixed(1)}`;
  return { line: line + end, area: `${area}${end}V${base}Z` };
}

/** The signals that say most about a project: what the plant does, what it gets, what is counted. */
export function usualLanes(): { name: string; tag: string; bool: boolean }[] {
  const plant = page.heads[0];
  const lanes: { name: string; tag: string; bool: boolean }[] = [];
  const take = (address: string | undefined): void => {
    if (address === undefined || lanes.some((lane) => lane.tag === address) || lanes.length >= 3) return;
    lanes.push({ name: page.nameOf(address), tag: address, bool: /^\w* ?\d+\.\d$|^[TIQM] \d+\.\d$/.test(address) });
  };
  const bool = (address: string) => /\.\d$/.test(address);
  const used = page.symbols.filter((s) => s.used > 0);
  take(plant?.signals.find((s) => s.direction === 'in' && s.driven === 'plant' && bool(s.address))?.address);
  take(used.find((s) => /^[QA] \d+\.\d$/.test(s.address))?.address);
  take(used.find((s) => /^[CZ] \d+$/.test(s.address))?.address ?? used.find((s) => ['REAL', 'INT'].includes(s.type))?.address);
  for (const symbol of used) if (/^[QIAE] \d+\.\d$/.test(symbol.address)) take(symbol.address);
  return lanes;
}
