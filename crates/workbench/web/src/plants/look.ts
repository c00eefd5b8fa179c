/** What the pictures of plants have in common: reading a look, waves, movement. */
import { page } from '../state.svelte';
import type { PlantHead } from '../rest';
import type { PlantLook } from '../wire';

export interface Plant {
  head: PlantHead | undefined;
  look: PlantLook;
}

export const stateOf = (look: PlantLook, name: string): number => look.state.find((row) => row[0] === name)?.[1] ?? 0;

/** The address of a signal, and what its bit or word has. */
export function addressOf(plant: Plant, signal: string): string {
  return plant.head?.signals.find((one) => one.name === signal)?.address ?? '';
}
export function bitOf(plant: Plant, signal: string): boolean {
  const found = plant.head?.signals.find((one) => one.name === signal);
  const place = /(\d+)\.(\d)$/.exec(found?.address ?? '');
  if (found === undefined || place === null) return false;
  const bytes = found.direction === 'in' ? plant.look.inputs : plant.look.outputs;
  const first = found.direction === 'in' ? plant.look.input : plant.look.output;
  return (((bytes[Number(place[1]) - first] ?? 0) >> Number(place[2])) & 1) === 1;
}
export function wordOf(plant: Plant, signal: string): number {
  const found = plant.head?.signals.find((one) => one.name === signal);
  const place = /(\d+)$/.exec(found?.address ?? '');
  if (found === undefined || place === null) return 0;
  const bytes = found.direction === 'in' ? plant.look.inputs : plant.look.outputs;
  const at = Number(place[1]) - (found.direction === 'in' ? plant.look.input : plant.look.output);
  return ((bytes[at] ?? 0) << 8) | (bytes[at + 1] ?? 0);
}

const calm = matchMedia('(prefers-reduced-motion: reduce)');
/** 0 to 1, again and again in so many seconds of the CPU; stands still where less motion is wanted. */
export function phase(period: number): number {
  return calm.matches ? 0 : (page.us / 1e6 / period) % 1;
}

/** The surface of water; rough while something flows. */
export function wave(x: number, y: number, width: number, rough: boolean): string {
  const pieces = 8;
  const step = width / pieces;
  let d = `M${x} ${y.toFixed(1)}`;
  for (let i = 0; i < pieces; i += 1) d += `q${(step / 2).toFixed(2)} ${(i % 2 === 1 ? 1 : -1) * (rough ? 2.2 : 1.1)} ${step.toFixed(2)} 0`;
  return d;
}
export const litres = (value: number) => `${value.toFixed(1)} l`;
