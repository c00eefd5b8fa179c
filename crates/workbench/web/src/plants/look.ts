/** A plant as its picture sees it: what it is, and one moment of it. */
import { page } from '../state.svelte';
import type { PlantHead, Signal } from '../rest';
import type { PlantLook } from '../wire';
import { speech } from '../words.svelte';
import { p } from './words';

export interface Plant {
  head: PlantHead;
  look: PlantLook;
}

export const stateOf = (look: PlantLook, name: string): number => knownOf(look, name) ?? 0;
/** What only the plant knows, if it says it. */
export const knownOf = (look: PlantLook, name: string): number | undefined => look.state.find((row) => row[0] === name)?.[1];
/** What the project has chosen. */
export const parameterOf = (plant: Plant, name: string, usual: number): number => plant.look.parameters[plant.head.parameters?.indexOf(name) ?? -1] ?? usual;

export const signalOf = (plant: Plant, name: string): Signal | undefined => plant.head.signals.find((one) => one.name === name);
/** Its address as the server has it, and as it is shown. */
export const terminalOf = (plant: Plant, signal: string): string => signalOf(plant, signal)?.address ?? '';
export const addressOf = (plant: Plant, signal: string): string => page.spell(terminalOf(plant, signal));
/** The symbol of a signal, or what faults call it. */
export function labelOf(plant: Plant, signal: string, room = 99): string {
  const address = addressOf(plant, signal);
  const symbol = page.nameOf(terminalOf(plant, signal));
  const name = symbol === address ? signal.replaceAll('_', ' ') : symbol;
  return name.length > room ? `${name.slice(0, room - 1)}…` : name;
}

/** Its bytes from its first one on. */
function bytes(plant: Plant, signal: Signal, count: number): number {
  const first = Number(/\d+/.exec(signal.address)?.[0] ?? 0) - (signal.direction === 'in' ? plant.look.input : plant.look.output);
  const all = signal.direction === 'in' ? plant.look.inputs : plant.look.outputs;
  let value = 0;
  for (let i = 0; i < count; i += 1) value = value * 256 + (all[first + i] ?? 0);
  return value;
}
export const isBit = (signal: Signal): boolean => /\.\d$/.test(signal.address);
export function bitOf(plant: Plant, name: string): boolean {
  const signal = signalOf(plant, name);
  const bit = signal === undefined ? null : /\.(\d)$/.exec(signal.address);
  return signal !== undefined && bit !== null && ((bytes(plant, signal, 1) >> Number(bit[1])) & 1) === 1;
}
/** The word of a signal without a sign. */
export function wordOf(plant: Plant, name: string): number {
  const signal = signalOf(plant, name);
  return signal === undefined || isBit(signal) ? 0 : bytes(plant, signal, 2);
}
/** The word with its sign, in the unit of its signal. */
export function measureOf(plant: Plant, name: string): number {
  const word = wordOf(plant, name);
  return (word > 0x7fff ? word - 0x10000 : word) / (signalOf(plant, name)?.per_unit ?? 1);
}

export interface Fault {
  signal: string;
  kind: string;
  value: string;
  /** As the server writes it. */
  text: string;
}
/** Faults that act, in parts: the signal, the kind, its number. */
export function faultsOf(plant: Plant): Fault[] {
  return (plant.look.acting ?? plant.look.faults).map((text) => {
    const [, signal = '', kind = '', value = ''] = /^(?:.*\.)?(\w+) +(\w+)(?:=([^@\s]+))?/.exec(text) ?? [];
    return { signal, kind, value, text };
  });
}
/** What a fault is, in words. */
export function inWords(fault: Fault): string {
  const value = fault.value.replace(/(\d)([a-zµ])/, '$1 $2');
  if (fault.kind === 'stuck') return value === '' ? p('stuckNow') : p('stuckAt', value);
  return fault.kind === 'drift' ? p('drifts', value) : fault.kind === 'late' ? p('lateBy', value) : p('bouncesFor', value);
}
/** What is wrong with a signal, in words; empty if nothing is. */
export function wrongWith(plant: Plant, signal: string): string {
  const fault = faultsOf(plant).find((one) => one.signal === signal);
  return fault === undefined ? '' : inWords(fault);
}

const calm = matchMedia('(prefers-reduced-motion: reduce)');
/** 0 to 1, again and again in so many seconds of the CPU; stands still where less motion is wanted. */
export function phase(period: number): number {
  if (calm.matches || !Number.isFinite(period) || period === 0) return 0;
  const part = (page.us / 1e6 / period) % 1;
  return part < 0 ? part + 1 : part;
}

/** The surface of water; rough while something flows. */
export function wave(x: number, y: number, width: number, rough: boolean): string {
  const pieces = 8;
  const step = width / pieces;
  let d = `M${x} ${y.toFixed(1)}`;
  for (let i = 0; i < pieces; i += 1) d += `q${(step / 2).toFixed(2)} ${(i % 2 === 1 ? 1 : -1) * (rough ? 2.2 : 1.1)} ${step.toFixed(2)} 0`;
  return d;
}

/** A number with so many decimals, as the language writes it. */
export function num(value: number, decimals = 1): string {
  const text = (Object.is(Math.round(value * 10 ** decimals), -0) ? 0 : value).toFixed(decimals);
  return speech.lang === 'de' ? text.replace('.', ',') : text;
}
export const litres = (value: number) => `${num(value)} l`;
export const part = (value: number) => Math.max(0, Math.min(1, Number.isFinite(value) ? value : 0));
