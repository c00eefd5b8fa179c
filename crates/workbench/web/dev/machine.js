// One project that runs: scans with their history, as the page asks for them.
import { readFileSync } from 'node:fs';
import { Program } from './program.js';
import { PLANTS } from './plants.js';

const KEEP = 60_000;
export const CYCLE_US = 10_000;

export class Machine {
  constructor(project) {
    this.recorded = JSON.parse(readFileSync(new URL(`./recorded/${project}.json`, import.meta.url), 'utf8'));
    this.project = project;
    this.hash = `${project}-1`;
    this.program = new Program(this.recorded);
    this.plant = PLANTS[project];
    this.mode = 'run';
    this.why = '';
    this.paused = false;
    this.speed = 1;
    this.forces = [];
    this.faults = {};
    this.events = [];
    this.names = new Map(this.recorded.symbols.map((symbol) => [symbol.symbol, symbol.address]));
    this.reset();
    this.event('mode', '16#4302', 'Mode change from STARTUP to RUN', 'warm restart');
  }

  reset() {
    this.vars = { ...this.plant.hands };
    this.state = this.plant.begin();
    this.n = 0;
    this.history = [];
    this.changes = [];
    this.#keep({ rows: {}, wrote: new Map() }, {});
  }

  event(kind, id, text, detail) {
    this.events.unshift({ kind, id, text, detail, n: this.n ?? 0, time: new Date().toISOString().slice(11, 23) });
    this.events.length = Math.min(this.events.length, 100);
  }

  get newest() {
    return this.history.length - 1 + this.first;
  }

  #keep(result, before) {
    if (this.history.length === 0) this.first = this.n;
    const { vars } = this;
    const snapshot = { ...vars };
    this.history.push({ n: this.n, us: this.n * CYCLE_US, vars: snapshot, before, plant: { ...this.state }, mode: this.mode, faults: { ...this.faults } });
    if (this.history.length > KEEP) {
      this.history.splice(0, 1000);
      this.first += 1000;
    }
    const last = this.history[this.history.length - 2]?.vars ?? {};
    for (const symbol of this.recorded.symbols) {
      const [a, b] = [last[symbol.address], snapshot[symbol.address]];
      if (typeof b === 'object' || a === b || (a ?? 0) === (b ?? 0)) continue;
      if (symbol.type === 'REAL' || symbol.type === 'INT') continue;
      const text = (v) => (symbol.type === 'WORD' ? (v ?? 0).toString(16).toUpperCase().padStart(4, '0') : String(v ?? 0));
      this.changes.unshift({ n: this.n, name: symbol.symbol, address: symbol.address, from: text(a), to: text(b), ...(result.wrote.has(symbol.address) ? { by: result.wrote.get(symbol.address) } : {}) });
    }
    this.changes.length = Math.min(this.changes.length, 1000);
  }

  /** One scan. */
  scan() {
    if (this.mode !== 'run') return;
    this.n += 1;
    this.plant.step(this.state, this.vars, CYCLE_US / 1e6, this.faults);
    for (const force of this.forces) this.vars[force.address] = Number(force.value);
    const before = { ...this.vars };
    const result = this.program.scan(this.vars, this.n * CYCLE_US);
    for (const force of this.forces) this.vars[force.address] = Number(force.value);
    this.#keep(result, before);
  }

  /** What a scan did: rows of every block, as the program did them then. */
  rows(n) {
    const entry = this.at(n);
    if (entry === undefined || Object.keys(entry.before).length === 0) return {};
    return this.program.scan({ ...entry.before }, entry.us).rows;
  }

  at(n) {
    return this.history[n - this.first];
  }

  address(name) {
    return this.names.get(name) ?? name;
  }

  value(n, name) {
    const [plain, format] = name.split(',');
    const address = this.address(plain);
    const raw = this.at(n)?.vars[address];
    const number = typeof raw === 'object' ? (raw.on ? Math.min(raw.ms, (this.at(n).us - raw.since) / 1000) : 0) : (raw ?? 0);
    const bool = /\.\d$/.test(address);
    if (format === undefined) return bool ? number !== 0 : number;
    switch (format) {
      case 'BOOL':
        return number ? '1' : '0';
      case 'HEX':
        return bool ? (number ? '1' : '0') : `W#16#${number.toString(16).toUpperCase().padStart(4, '0')}`;
      case 'COUNTER':
        return `C#${number}`;
      case 'BIN':
        return `2#${number.toString(2).padStart(bool ? 1 : 16, '0')}`;
      case 'BCD':
        return number.toString(16);
      default:
        return String(number);
    }
  }

  setMode(mode) {
    if (mode === 'mres') {
      this.reset();
      return;
    }
    if (mode === this.mode) return;
    this.mode = mode;
    if (mode === 'stop') {
      this.why = 'STOP was pressed on this page';
      for (const name of Object.keys(this.vars)) if (/^Q/.test(name)) this.vars[name] = 0;
      this.n += 1;
      this.#keep({ rows: {}, wrote: new Map() }, this.history[this.history.length - 1]?.before ?? {});
      this.event('error', '16#4303', 'STOP by the mode switch', 'RUN → STOP · outputs off');
    } else {
      this.why = '';
      this.event('mode', '16#4302', 'Mode change from STARTUP to RUN', 'warm restart');
    }
  }
}
