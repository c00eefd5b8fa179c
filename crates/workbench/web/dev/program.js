// Runs the small part of STL that the recorded examples need, one row for each statement. Only for development: the product has its own machine.
const BITS = { FC: 1, RLO: 2, STA: 4, OR: 8, BR: 256 };
const GERMAN = { U: 'A', UN: 'AN', 'U(': 'A(', 'UN(': 'AN(', ZR: 'CD', ZV: 'CU', SE: 'SD', SI: 'SP', SV: 'SE', SA: 'SF', SPB: 'JC', SPBN: 'JCN', BEB: 'BEC' };

export const english = (op, german) => (german ? (GERMAN[op] ?? op) : op);
export const germanOf = (op) => Object.entries(GERMAN).find(([, en]) => en === op)?.[0] ?? op;
export const germanAddress = (text) => text.replace(/^I(?=[BWD]? ?\d)/, 'E').replace(/^Q(?=[BWD]? ?\d)/, 'A').replace(/^C(?= ?\d)/, 'Z');

const WORDS = { I: 'the input', Q: 'the output', M: 'the bit memory', C: 'the counter', T: 'the timer' };

export class Program {
  constructor(recorded) {
    this.german = recorded.german;
    this.blocks = new Map(recorded.blocks.map((block) => [block.block, block.networks.flatMap((network) => network.statements.map((statement) => ({ ...statement, network: network.n, en: english(statement.op, recorded.german) })))]));
    this.symbolOf = new Map(recorded.symbols.map((symbol) => [symbol.symbol, symbol.address]));
    this.nameOf = new Map(recorded.symbols.map((symbol) => [symbol.address, symbol.symbol]));
  }

  /** One scan on variables; gives the rows of each block and who wrote what. */
  scan(vars, us) {
    const out = { rows: {}, wrote: new Map() };
    this.#block('OB1', '', vars, us, out, { a1: 0, a2: 0 });
    return out;
  }

  #block(block, instance, vars, us, out, accu) {
    const statements = this.blocks.get(block) ?? [];
    const rows = [];
    out.rows[block] = rows;
    let fc = 0;
    let rlo = 0;
    let or = 0;
    let sta = 0;
    const stack = [];
    const key = (operand) => (operand.startsWith('#') ? `${instance}.${operand}` : operand);
    const get = (name) => vars[name] ?? 0;
    const truth = (operand) => {
      const name = key(operand);
      const real = alias.get(name) ?? name;
      if (/^T \d/.test(real)) return timer(vars, real, us);
      return get(real) ? 1 : 0;
    };
    const alias = out.alias ?? new Map();
    const put = (operand, value, at) => {
      const name = key(operand);
      if (get(name) !== value) out.wrote.set(name, { block, network: at.network, line: at.line });
      vars[name] = value;
    };
    for (const s of statements) {
      const op = s.en;
      let why = '';
      const named = `${s.operand}${s.symbol ? ` "${s.symbol}"` : ''}`;
      const kind = s.operand.startsWith('#') ? '' : `${WORDS[s.operand[0]] ?? ''} `;
      const check = (bit, negated, join) => {
        sta = bit;
        const value = negated ? 1 - bit : bit;
        const first = fc === 0;
        const before = rlo;
        rlo = first ? value : join(rlo, value);
        fc = 1;
        const inverted = negated ? `, inverted ${value},` : '';
        why = first ? `${kind}${named} is ${bit}${inverted} and begins a logic string, so the RLO becomes ${rlo}` : before === 0 && /^A/.test(op) ? `the RLO was 0 already, so it stays 0; ${kind}${named} is ${bit}` : `${kind}${named} is ${bit}${inverted} and the RLO was ${before}, so the RLO ${before === rlo ? 'stays' : 'becomes'} ${rlo}`;
      };
      const and = (a, b) => a & b;
      const orOf = (a, b) => a | b;
      const xor = (a, b) => a ^ b;
      if (op === 'A' || op === 'AN') check(truth(s.operand), op === 'AN', and);
      else if (op === 'O' || op === 'ON') check(truth(s.operand), op === 'ON', orOf);
      else if (op === 'X' || op === 'XN') check(truth(s.operand), op === 'XN', xor);
      else if (op === 'A(' || op === 'O(' || op === 'AN(') {
        stack.push([op, fc === 0 ? 1 : rlo, fc]);
        why = `the RLO ${rlo} is kept until the bracket closes`;
        fc = 0;
        sta = 1;
      } else if (op === ')') {
        const [opened, before, had] = stack.pop() ?? ['A(', 1, 0];
        const inside = rlo;
        rlo = opened === 'O(' ? (had ? before | inside : inside) : had ? before & inside : inside;
        fc = 1;
        sta = 1;
        why = `the bracket is ${inside}, so the RLO becomes ${rlo}`;
      } else if (op === '=') {
        put(s.operand, rlo, s);
        sta = rlo;
        fc = 0;
        why = `the RLO is ${rlo}, so ${named} becomes ${rlo}`;
      } else if (op === 'S' || op === 'R') {
        if (/^C \d/.test(s.operand)) {
          const edge = `${s.operand}/${s.line}`;
          if (op === 'S') {
            if (rlo && !get(edge)) put(s.operand, bcd(accu.a1), s);
            vars[edge] = rlo;
            why = rlo ? `the RLO is 1, so ${named} takes ${get(s.operand)}` : `the RLO is 0, so nothing happens; ${named} is at ${get(s.operand)}`;
          } else {
            if (rlo) put(s.operand, 0, s);
            why = rlo ? `the RLO is 1, so ${named} is reset to 0` : `the RLO is 0, so ${named} is not reset; it is at ${get(s.operand)}`;
          }
          sta = get(s.operand) ? 1 : 0;
        } else {
          if (rlo) put(s.operand, op === 'S' ? 1 : 0, s);
          sta = truth(s.operand);
          why = rlo ? `the RLO is 1, so ${named} is ${op === 'S' ? 'set to 1' : 'reset to 0'}` : `the RLO is 0, so nothing is written: ${named} stays ${sta}`;
        }
        fc = 0;
      } else if (op === 'FP' || op === 'FN') {
        const before = truth(s.operand);
        const now = rlo;
        rlo = op === 'FP' ? (now && !before ? 1 : 0) : !now && before ? 1 : 0;
        why = rlo ? `the RLO has risen, so the RLO is 1 for this scan; ${named} keeps ${now} for the next time` : `the RLO is ${now}, so there is no rising edge; ${named} keeps ${now} for the next time`;
        put(s.operand, now, s);
        sta = rlo;
        fc = 1;
      } else if (op === 'CD' || op === 'CU') {
        const edge = `${s.operand}/${s.line}`;
        const before = get(s.operand);
        if (rlo && !get(edge)) put(s.operand, Math.max(0, Math.min(999, before + (op === 'CD' ? -1 : 1))), s);
        why = rlo && !get(edge) ? `the RLO has risen, so ${named} counts ${op === 'CD' ? 'down' : 'up'} from ${before} to ${get(s.operand)}` : `the RLO has not risen, so ${named} stays at ${before}`;
        vars[edge] = rlo;
        sta = get(s.operand) ? 1 : 0;
        fc = 0;
      } else if (op === 'SD') {
        const name = alias.get(key(s.operand)) ?? s.operand;
        const at = vars[name] ?? { on: 0, since: 0, ms: 0 };
        vars[name] = rlo ? (at.on ? at : { on: 1, since: us, ms: accu.ms ?? 0 }) : { on: 0, since: 0, ms: 0 };
        why = rlo ? `the RLO is 1, so ${named} runs` : `the RLO is 0, so ${named} does not run`;
        fc = 0;
      } else if (op === 'L' || op === 'LC') {
        accu.a2 = accu.a1;
        const time = /^(?:S5T|T)#([\d.]+)(MS|S)/i.exec(s.operand) ?? (s.operand.startsWith('#') ? /()(4000)/.exec('4000') : null);
        if (time !== null) {
          accu.ms = time[2] === '4000' ? 4000 : Number(time[1]) * (time[2].toUpperCase() === 'S' ? 1000 : 1);
          accu.a1 = 0x2000 | Number.parseInt(String(Math.round(accu.ms / 1000) || 1), 16);
          why = `the constant ${s.operand} comes into ACCU 1`;
        } else if (s.operand.startsWith('C#')) {
          accu.a1 = Number.parseInt(s.operand.slice(2), 16);
          why = `the constant ${s.operand} comes into ACCU 1; ACCU 2 takes the old ACCU 1, ${hex(accu.a2)}`;
        } else {
          accu.a1 = op === 'LC' ? Number.parseInt(String(get(s.operand)), 16) : get(s.operand);
          why = `${named} is at ${get(s.operand)}, which comes into ACCU 1 as BCD digits`;
        }
      } else if (op === 'T') {
        put(s.operand, accu.a1, s);
        why = `${named} takes ${hex(accu.a1)} from ACCU 1`;
      } else if (op === 'CLR' || op === 'SET') {
        rlo = op === 'SET' ? 1 : 0;
        fc = 0;
        why = `the RLO becomes ${rlo}`;
      } else if (op === 'CALL') {
        this.#call(s, vars, us, out, accu);
        fc = 0;
        why = 'the block was called and came back';
      }
      const stw = (fc ? BITS.FC : 0) | (rlo ? BITS.RLO : 0) | (sta ? BITS.STA : 0) | (or ? BITS.OR : 0) | BITS.BR;
      rows.push([s.line, 1, stw, accu.a1, accu.a2, why]);
    }
  }

  #call(s, vars, us, out, accu) {
    const inside = /\(([\s\S]*)\)/.exec(s.operand)?.[1] ?? '';
    const alias = new Map();
    const outputs = [];
    for (const part of inside.split(',')) {
      const [formal, actual] = part.split(':=').map((one) => one.trim());
      if (actual === undefined) continue;
      const address = this.symbolOf.get(actual.replaceAll('"', ''));
      const local = `DB20.#${formal}`;
      if (address === undefined) continue;
      if (address.startsWith('T ')) alias.set(local, address);
      else if (address.startsWith('Q ')) outputs.push([local, address]);
      else vars[local] = vars[address] ?? 0;
    }
    out.alias = alias;
    this.#block('FB20', 'DB20', vars, us, out, accu);
    for (const [local, address] of outputs) {
      if ((vars[address] ?? 0) !== (vars[local] ?? 0)) out.wrote.set(address, out.wrote.get(local) ?? { block: 'FB20', network: 1, line: s.line });
      vars[address] = vars[local] ?? 0;
    }
  }
}

const bcd = (value) => Number.parseInt((value & 0xfff).toString(16), 10) || 0;
const hex = (value) => (value >>> 0).toString(16).toUpperCase();
function timer(vars, name, us) {
  const at = vars[name];
  return at?.on && us - at.since >= at.ms * 1000 ? 1 : 0;
}
export { BITS };
