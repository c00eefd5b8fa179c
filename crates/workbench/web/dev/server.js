// The server that the page is developed and tested against: speaks its protocol, runs recorded examples. Not shipped.
import { createServer } from 'node:http';
import { randomBytes } from 'node:crypto';
import { existsSync, readFileSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { WebSocketServer } from 'ws';
import { flows } from './flow.js';
import { CYCLE_US, Machine } from './machine.js';
import { english, germanAddress, germanOf } from './program.js';

const port = Number(process.env.PORT ?? 7301);
const dist = fileURLToPath(new URL('../../dist/', import.meta.url));
const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };
const EXAMPLES = ['dosing', 'star-delta', 'tank'];
const ABOUT = {
  A: 'And: the RLO becomes RLO AND bit. After an assignment it begins a new logic string.', AN: 'And Not: as A, with the bit inverted.', FP: 'Positive edge: the RLO is 1 for one scan when it rises.', L: 'Load: ACCU 2 takes ACCU 1, and ACCU 1 the value.',
  S: 'Set: with RLO 1 the bit becomes 1, a counter its value.', R: 'Reset: with RLO 1 the bit becomes 0, a counter 0.', CD: 'Count down: with a rising RLO the counter loses 1.', LC: 'Load as BCD: ACCU 1 takes three BCD digits.', T: 'Transfer: the operand takes what is in ACCU 1.',
};

let machine = new Machine(process.env.PROJECT ?? 'dosing');
let pages = new Set();
const role = () => (process.env.ROLE === 'view' ? 'view' : 'program');

// ---- time
let due = Date.now();
setInterval(() => {
  const now = Date.now();
  const lag = Math.min(500, now - due);
  const scans = Math.floor((lag * machine.speed) / (CYCLE_US / 1000));
  if (scans <= 0) return;
  due = machine.speed > 0 ? now - ((lag * machine.speed) % (CYCLE_US / 1000)) / machine.speed : now;
  if (!machine.paused) for (let i = 0; i < scans; i += 1) machine.scan();
}, 10);

// ---- what a page sees
function order(rows) {
  const inner = Object.keys(rows).filter((block) => block !== 'OB1');
  return [...inner, 'OB1'].flatMap((block) => (rows[block] ?? []).map((row, index) => ({ block, index, row })));
}

function snapshot(page, sub, n) {
  const entry = machine.at(n);
  switch (sub.what) {
    case 'rows': {
      const rows = machine.rows(n)[sub.block];
      const before = page.statement === undefined ? [] : (machine.rows(n - 1)[sub.block] ?? []);
      const all = machine.recorded.blocks.find((block) => block.block === sub.block)?.networks.flatMap((network) => network.statements) ?? [];
      const ran = page.statement === undefined ? Infinity : order(machine.rows(n)).slice(0, page.statement + 1).filter((one) => one.block === sub.block).length;
      return all.slice(sub.from, sub.to + 1).map((statement, i) => {
        const index = sub.from + i;
        const source = index < ran ? rows?.[index] : before[index];
        if (source === undefined) return [statement.line, 0, 0, 0, 0];
        const row = source.slice(0, 5);
        row[1] = index < ran ? 1 : 2;
        if (sub.reason === index) row.push(index < ran ? source[5] : '');
        return row;
      });
    }
    case 'flow': {
      const block = machine.recorded.blocks.find((one) => one.block === sub.block);
      const rows = machine.rows(n)[sub.block] ?? [];
      return Object.fromEntries(sub.networks.map((number) => {
        const svg = block?.[sub.view]?.find((one) => one.n === number)?.svg;
        return [number, svg === undefined ? [] : flows(svg, (line) => rows.find((row) => row[0] === line))];
      }));
    }
    case 'tags':
      return Object.fromEntries(sub.names.map((name) => [name, machine.value(n, name)]));
    case 'plant':
      return entry === undefined ? [] : [machine.plant.look(entry.plant, entry.vars, entry.faults)];
    case 'leds':
      return { sf: 0, bf: 0, dc5v: 1, frce: machine.forces.length > 0 ? 1 : 0, run: machine.mode === 'run' ? 1 : 0, stop: machine.mode === 'stop' ? 1 : 0 };
    case 'changes':
      return machine.changes.filter((change) => change.n <= n).slice(0, 100);
    case 'clients':
      return [...pages].map((one) => ({ id: one.peer, name: 'page', protocol: 'web', peer: one.peer, role: role(), reads: 20, writes: one.writes }));
    case 'diag':
      return machine.events;
    case 'cycle': {
      const last = CYCLE_US + Math.round(Math.sin(n / 7) * 120 + Math.random() * 260);
      page.most = Math.max(page.most ?? 0, last);
      return { last_us: last, mean_us: 9980, max_us: page.most, program_us: 9, histogram: [1, 2, 3, 8, 16, 37, 62, 41, 18, 7, 3, 1, 1].map((count, i) => [8000 + i * 333, count]) };
    }
    case 'forces':
      return machine.forces.map((force) => ({ ...force, terminal: String(Number(machine.plant.hands[force.address] ?? 0)) }));
    default:
      return null;
  }
}

const SLOW = new Set(['cycle', 'clients', 'diag']);
function push(page, all = false) {
  const n = page.at === 'live' ? machine.newest : Math.max(machine.first, Math.min(machine.newest, page.at));
  const entry = machine.at(n);
  const s = {};
  page.round = (page.round ?? 0) + 1;
  for (const [id, sub] of page.subs) {
    if (!all && SLOW.has(sub.what) && sub.sent !== undefined && page.round % 10 !== 0) continue;
    const now = snapshot(page, sub, n);
    const text = JSON.stringify(now);
    if (!all && sub.sent === text) continue;
    if (!all && sub.what === 'rows' && sub.last !== undefined) s[id] = Object.fromEntries(now.map((row, i) => [i + sub.from, row]).filter(([, row], i) => JSON.stringify(row) !== JSON.stringify(sub.last[i])));
    else if (!all && (sub.what === 'tags' || sub.what === 'leds') && sub.last !== undefined) s[id] = Object.fromEntries(Object.entries(now).filter(([name, value]) => sub.last[name] !== value));
    else s[id] = now;
    sub.sent = text;
    sub.last = now;
  }
  let pos;
  if (page.statement !== undefined) {
    const one = order(machine.rows(n))[page.statement];
    if (one !== undefined) pos = { block: one.block, index: one.index, line: one.row[0], reason: one.row[5] };
  }
  page.seq = (page.seq ?? 0) + 1;
  const live = page.at === 'live';
  page.socket.send(JSON.stringify({ t: 'scan', seq: page.seq, n, t_us: entry?.us ?? 0, mode: live ? machine.mode : (entry?.mode ?? machine.mode), oldest: machine.first, newest: machine.newest, newest_us: machine.newest * CYCLE_US, live, paused: machine.paused, speed: machine.speed, ...(pos ? { pos } : {}), ...(machine.why ? { why: machine.why } : {}), s }));
}
setInterval(() => {
  for (const page of pages) if (page.ready) push(page);
}, 50);

function step(page, unit, by) {
  if (page.at === 'live') {
    page.at = machine.newest;
    if (unit !== 'scan') {
      if (by > 0 && machine.paused) {
        machine.scan();
        page.at = machine.newest;
      }
      page.statement = by > 0 ? -1 : order(machine.rows(page.at)).length;
    }
  }
  const count = () => order(machine.rows(page.at)).length;
  if (unit === 'scan') {
    page.statement = undefined;
    page.at += by;
    if (page.at > machine.newest) {
      if (machine.paused) machine.scan();
      page.at = machine.newest;
      if (!machine.paused) page.at = 'live';
    }
    if (page.at !== 'live') page.at = Math.max(machine.first, page.at);
    return;
  }
  page.statement ??= by > 0 ? -1 : count();
  const networkOf = (k) => {
    const one = order(machine.rows(page.at))[k];
    return one === undefined ? '' : `${one.block}/${machine.program.blocks.get(one.block)?.[one.index]?.network}`;
  };
  const from = networkOf(page.statement);
  do {
    page.statement += by;
  } while (unit === 'network' && page.statement >= 0 && page.statement < count() - 1 && networkOf(page.statement) === from);
  if (page.statement < 0) {
    page.at = Math.max(machine.first + 1, page.at - 1);
    page.statement = count() - 1;
  } else if (page.statement >= count()) {
    if (page.at >= machine.newest && machine.paused) machine.scan();
    page.at = Math.min(machine.newest, page.at + 1);
    page.statement = 0;
  }
}

function take(page, message) {
  switch (message.t) {
    case 'hello':
      page.lang = message.lang;
      if (!page.ready) {
        page.ready = true;
        page.socket.send(JSON.stringify({ t: 'welcome', v: 1, cpu: '315-2PN/DP', project: machine.project, program: machine.hash, role: role(), oldest: machine.first, newest: machine.newest, cycle_us: CYCLE_US, mnemonics: machine.recorded.german ? 'de' : 'en', examples: EXAMPLES, offers: process.env.PLAIN ? [] : ['flow', 'step'] }));
      }
      break;
    case 'sub':
      page.subs.set(message.id, { ...message });
      break;
    case 'unsub':
      page.subs.delete(message.id);
      break;
    case 'at':
      if (message.scan === 'live') {
        page.at = 'live';
        page.statement = undefined;
      } else if (message.scan !== undefined) {
        page.at = message.scan >= machine.newest && !machine.paused ? 'live' : message.scan;
        page.statement = undefined;
      } else step(page, message.step, message.n);
      push(page, true);
      break;
    case 'history': {
      const channels = {};
      for (const name of message.channels) {
        let last;
        channels[name] = [];
        for (let n = Math.max(machine.first, message.from); n <= Math.min(machine.newest, message.to); n += 1) {
          const value = Number(machine.value(n, name));
          if (value !== last) channels[name].push([n, value]);
          last = value;
        }
      }
      page.socket.send(JSON.stringify({ t: 'history', id: message.id, from: message.from, to: message.to, channels }));
      break;
    }
    case 'who': {
      const address = machine.address(message.name);
      const found = machine.changes.find((change) => change.address === address && change.n <= message.scan);
      const named = `${address}${machine.program.nameOf.has(address) ? ` "${machine.program.nameOf.get(address)}"` : ''}`;
      const text = found === undefined ? `Nothing has written ${named} yet.` : found.by === undefined ? `${named} became ${found.to} in scan ${found.n}: the plant or a client wrote it.` : `${found.by.block.replace(/(\D)(\d)/, '$1 $2')}, network ${found.by.network}, line ${found.by.line} wrote ${found.to} to ${named} in scan ${found.n}.`;
      page.socket.send(JSON.stringify({ t: 'who', id: message.id, name: message.name, text, ...(found?.by ?? {}), scan: found?.n }));
      break;
    }
  }
}

// ---- REST
const GROUP = (block) => (block.startsWith('DB') ? 'data' : block === 'OB100' ? 'restart' : 'cyclic');
const shown = (statement, mnemonics) => {
  const en = english(statement.op, machine.recorded.german);
  return mnemonics === 'de' ? { ...statement, op: germanOf(en), operand: germanAddress(statement.operand) } : { ...statement, op: en };
};
function block(name, view, mnemonics) {
  const found = machine.recorded.blocks.find((one) => one.block === name);
  if (found === undefined) return undefined;
  const instances = name === 'FB20' ? ['DB20'] : [];
  return { block: name, title: found.title, symbol: found.symbol, language: 'STL', instances, networks: found.networks.map((network) => ({ ...network, ...(view === 'stl' ? {} : (found[view]?.find((one) => one.n === network.n) ?? {})), statements: network.statements.map((statement) => shown(statement, mnemonics)) })) };
}

function answer(method, path, query, body, page) {
  const [first, second] = path;
  const key = `${method} ${first}`;
  if (method !== 'GET' && role() === 'view') return [403, { code: 'P7140', detail: 'This page may only look.' }];
  switch (key) {
    case 'GET blocks':
      if (second !== undefined) {
        const got = block(second, query.get('view') ?? 'stl', query.get('mnemonics') ?? 'en');
        return got === undefined ? [404, { code: 'P7141', detail: `There is no block ${second}.` }] : [200, got];
      }
      return [200, machine.recorded.blocks.map((one) => ({ block: one.block, title: one.title, symbol: one.symbol, language: 'STL', group: GROUP(one.block), depth: /^F/.test(one.block) ? 1 : 0, instances: one.block === 'FB20' ? ['DB20'] : [] })).sort((a, b) => Number(a.depth) - Number(b.depth))];
    case 'GET symbols':
      return [200, machine.recorded.symbols];
    case 'GET plants':
      return [200, [machine.plant.head]];
    case 'GET refs':
      return [200, machine.recorded.refs.filter((ref) => ref.address === query.get('name') || ref.symbol === query.get('name')).map((ref) => ({ ...ref, references: ref.references.map((one) => ({ ...one, title: machine.recorded.blocks.find((b) => b.block === one.block.replace(' ', ''))?.networks[one.network - 1]?.title ?? '' })) }))];
    case 'GET assignments':
      return [200, machine.recorded.assignments];
    case 'GET structure':
      return [200, machine.recorded.structure];
    case 'GET info':
      return [200, { cpu: '315-2PN/DP', work_memory: 393216, work_used: 4312, local_data: 32768, servers: [{ name: 'web', address: `127.0.0.1:${port}` }], connections: 32 }];
    case 'GET explain':
      return [200, { text: ABOUT[english(second ?? '', true)] ?? ABOUT[second] ?? '' }];
    case 'GET watch':
      return second === undefined ? [200, [`${machine.project}.watch`]] : second === 'big.watch' ? [200, Array.from({ length: 10_000 }, (_, i) => ({ name: `M ${(i >> 3) % 1024}.${i & 7}`, format: 'BOOL', comment: `row ${i}` }))] : [200, machine.recorded.symbols.filter((s) => /^([IQMCT]|[IQM][WD]) /.test(s.address)).slice(0, 12).map((s) => ({ name: s.symbol, format: s.type === 'COUNTER' ? 'COUNTER' : s.type === 'WORD' ? 'HEX' : s.type === 'BOOL' ? 'BOOL' : 'DEC', comment: s.comment }))];
    case 'GET forces':
      return [200, machine.forces];
    case 'GET diagnostics':
      return [200, machine.events.map((event, i) => `${i + 1} ${event.time} ${event.id} ${event.text}`).join('\n') + '\n', 'text/plain'];
    case 'GET state':
      return [200, { n: machine.newest, mode: machine.mode }];
    case 'GET trace': {
      const names = query.get('channels').split(',');
      const lines = [['scan', ...names].join(',')];
      for (let n = Number(query.get('from')); n <= Number(query.get('to')); n += 1) lines.push([n, ...names.map((name) => Number(machine.value(n, name)))].join(','));
      return [200, lines.join('\n') + '\n', 'text/csv'];
    }
    case 'POST mode':
      machine.setMode(body.mode);
      return [204];
    case 'POST time':
      if (body.pause) machine.paused = true;
      if (body.go) machine.paused = false;
      if (body.speed !== undefined) machine.speed = body.speed;
      return [204];
    case 'PATCH tags':
      machine.state.auto = false;
      for (const [name, value] of Object.entries(body)) machine.vars[machine.address(name)] = typeof value === 'string' ? Number.parseInt(value.replace(/^.*#/, ''), 10) || (value === 'true' ? 1 : 0) : Number(value);
      return [204];
    case 'POST forces': {
      const address = machine.address(body.name);
      if (!/^[IQ]/.test(address)) return [409, { code: 'P7142', detail: `${address} cannot be forced: a CPU 315 forces inputs and outputs only.` }];
      machine.forces = machine.forces.filter((force) => force.address !== address).concat({ name: machine.program.nameOf.get(address) ?? '', address, value: String(body.value), reason: body.reason, by: 'operator, from this page', since: new Date().toISOString().slice(11, 19), n: machine.newest, terminal: '0' });
      return [200, machine.forces];
    }
    case 'DELETE forces':
      for (const force of machine.forces) if ((second === undefined || force.address === second) && machine.plant.hands[force.address] !== undefined) machine.vars[force.address] = machine.plant.hands[force.address];
      machine.forces = second === undefined ? [] : machine.forces.filter((force) => force.address !== second);
      return [200, machine.forces];
    case 'POST faults': {
      const signal = body.name.split('.').pop();
      if (body.fault === '') delete machine.faults[signal];
      else machine.faults[signal] = body.fault;
      return [204];
    }
    case 'POST project':
      machine = new Machine(body.example);
      for (const one of pages) {
        one.at = 'live';
        one.statement = undefined;
        for (const [id, sub] of one.subs) if (sub.what === 'rows' || sub.what === 'flow') one.subs.delete(id);
        for (const sub of one.subs.values()) sub.sent = undefined;
        one.socket.send(JSON.stringify({ t: 'program', hash: machine.hash, changed: [], project: machine.project }));
      }
      return [204];
    default:
      void page;
      return [404, { code: 'P7141', detail: `There is no ${key}.` }];
  }
}

const server = createServer((request, response) => {
  const url = new URL(request.url, `http://127.0.0.1:${port}`);
  if (url.pathname.startsWith('/api/v1/')) {
    const parts = [];
    request.on('data', (part) => parts.push(part));
    request.on('end', () => {
      let out;
      try {
        out = answer(request.method, url.pathname.slice(8).split('/').map(decodeURIComponent), url.searchParams, parts.length === 0 ? {} : JSON.parse(Buffer.concat(parts).toString()), null);
      } catch (error) {
        out = [500, { code: 'P0000', detail: String(error) }];
      }
      const [status, content, type] = out;
      response.writeHead(status, { 'content-type': status >= 400 ? 'application/problem+json' : (type ?? 'application/json') });
      response.end(content === undefined ? undefined : typeof content === 'string' ? content : JSON.stringify(content));
    });
    return;
  }
  const path = url.pathname === '/' ? 'index.html' : normalize(url.pathname).replace(/^\/+/, '');
  const file = join(dist, path);
  if (!file.startsWith(dist) || !existsSync(file) || path === '') {
    response.writeHead(404, { 'content-type': 'text/plain' }).end('not here');
    return;
  }
  const nonce = randomBytes(16).toString('base64');
  const headers = { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream', 'x-content-type-options': 'nosniff' };
  let content = readFileSync(file);
  if (path === 'index.html') {
    headers['content-security-policy'] = `default-src 'none'; script-src 'self' 'nonce-${nonce}'; style-src 'self' 'nonce-${nonce}'; img-src 'self' data:; connect-src 'self' ws://127.0.0.1:${port}; base-uri 'none'; form-action 'none'; frame-ancestors 'none'`;
    content = Buffer.from(content.toString().replaceAll('__NONCE__', nonce));
  }
  response.writeHead(200, headers).end(content);
});

const sockets = new WebSocketServer({ server, path: '/ws' });
sockets.on('connection', (socket, request) => {
  const page = { socket, subs: new Map(), at: 'live', writes: 0, peer: `127.0.0.1:${request.socket.remotePort}` };
  pages.add(page);
  socket.on('message', (data) => {
    try {
      take(page, JSON.parse(data.toString()));
    } catch (error) {
      console.error(error);
    }
  });
  socket.on('close', () => pages.delete(page));
});
server.listen(port, '127.0.0.1', () => console.log(`http://127.0.0.1:${port}/`));
