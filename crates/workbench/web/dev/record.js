// Records what `sieben` says about examples, for the development server: `node dev/record.js SIEBEN FOLDER NAME…`.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [sieben, examples, ...names] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), 'record-'));

function run(...args) {
  try {
    return execFileSync(sieben, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'], maxBuffer: 1 << 26 });
  } catch (error) {
    return error.stdout ?? '';
  }
}
const json = (...args) => JSON.parse(run(...args) || 'null');

function csv(text) {
  const [head, ...rows] = text.trim().split(/\r?\n/).map((line) => line.match(/("([^"]|"")*"|[^,]*)(,|$)/g).map((cell) => cell.replace(/,$/, '').replace(/^"|"$/g, '')));
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i] ?? ''])));
}

for (const name of names) {
  const folder = join(examples, name);
  const german = readFileSync(join(folder, 'symbols.csv'), 'utf8').includes(',E ');
  const english = (address) => (german ? address.replace(/^E(?=[BWD]? ?\d)/, 'I').replace(/^A(?=[BWD]? ?\d)/, 'Q').replace(/^Z(?= ?\d)/, 'C') : address);
  const symbols = csv(readFileSync(join(folder, 'symbols.csv'), 'utf8')).map((row) => ({ ...row, address: english(row.address) }));
  const bySymbol = new Map(symbols.map((row) => [row.symbol, row.address]));
  const byAddress = new Map(symbols.map((row) => [row.address, row.symbol]));
  const refs = json('refs', folder, '--json').map((ref) => ({ ...ref, address: english(ref.address) }));
  const uses = new Map(refs.map((ref) => [ref.address, ref.references.length]));
  const blocks = [];
  for (const file of readdirSync(folder).filter((one) => one.endsWith('.awl'))) {
    let block = null;
    let network = null;
    readFileSync(join(folder, file), 'utf8').replace(/CALL[^;]*;/g, (call) => call.replace(/\n\s*/g, ' ') + '\n'.repeat(call.split('\n').length - 1)).split('\n').forEach((text, i) => {
      const begin = /^(ORGANIZATION_BLOCK|FUNCTION_BLOCK|FUNCTION|DATA_BLOCK)\s+(?:"([^"]+)"|([A-Z]+)\s*(\d+))/.exec(text);
      if (begin !== null) {
        const address = begin[2] === undefined ? `${begin[3]} ${begin[4]}` : (bySymbol.get(begin[2]) ?? begin[2]);
        block = { block: address.replace(' ', ''), title: '', symbol: byAddress.get(address) ?? '', language: 'STL', networks: [], code: false, file };
        blocks.push(block);
        network = null;
      } else if (block !== null && /^TITLE\s*=/.test(text)) {
        const title = text.replace(/^TITLE\s*=\s*/, '').trim();
        if (network === null) block.title = title;
        else network.title = title;
      } else if (/^BEGIN/.test(text) && block !== null) block.code = !block.block.startsWith('DB');
      else if (/^END_/.test(text)) block = block !== null && /^END_(ORG|FUNC|DATA)/.test(text) ? null : block;
      else if (/^NETWORK/.test(text) && block !== null) {
        network = { n: block.networks.length + 1, title: '', comment: '', view: 'stl', statements: [] };
        block.networks.push(network);
      } else if (network !== null && /^\/\//.test(text) && network.statements.length === 0) network.comment += `${network.comment === '' ? '' : '\n'}${text.replace(/^\/\/ ?/, '')}`;
      else if (network !== null) {
        const found = /^\s*(?:(\w+):)?\s*([A-Z=+\-*\/<>()_]+\d*\(?)\s*([^;]*);/.exec(text);
        if (found === null || found[2] === 'TITLE') return;
        const given = found[3].trim();
        const quoted = /^"([^"]+)"$/.exec(given)?.[1];
        const operand = quoted === undefined ? given.replace(/\s+/g, ' ') : (bySymbol.get(quoted) ?? given);
        const inEnglish = english(operand);
        const address = /^([IQMTC]|[IQM][BWD]) \d/.test(inEnglish) ? inEnglish : undefined;
        network.statements.push({ line: i + 1, ...(found[1] ? { label: found[1] } : {}), op: found[2], operand: inEnglish, symbol: quoted ?? byAddress.get(inEnglish) ?? '', ...(address ? { address } : {}) });
      }
    });
  }
  for (const block of blocks.filter((one) => one.code)) {
    for (const form of ['lad', 'fbd']) {
      const lines = run('render', folder, '--block', block.block, '--as', form, '--json').trim().split('\n').filter((line) => line.startsWith('{')).map((line) => JSON.parse(line));
      block[form] = lines.map((line) => {
        const out = { n: line.network, view: line.as, ...(line.reason ? { reason: line.reason } : {}) };
        if (line.as !== 'stl') {
          const path = join(scratch, `${form}.svg`);
          run('exec', folder, '--scans', '2', '--status', path, '--network', `${block.block}/${line.network}`, '--as', form);
          let svg = '';
          try {
            svg = readFileSync(path, 'utf8');
          } catch {
            run('render', folder, '--block', block.block, '--network', String(line.network), '--as', form, '-o', path);
            svg = readFileSync(path, 'utf8');
          }
          out.svg = svg.replace(/<style>[\s\S]*?<\/style>\n?/, '').replace(/ data-flow="[^"]*"/g, ' data-flow=""').replace(/<rect class="paper"[^>]*\/>\n?/, '');
        }
        return out;
      });
    }
  }
  const out = {
    project: name,
    german,
    symbols: symbols.map((row) => ({ symbol: row.symbol, address: row.address, type: row.type, comment: row.comment, used: uses.get(row.address) ?? 0 })),
    refs,
    structure: json('structure', folder, '--json'),
    assignments: json('assignments', folder, '--json'),
    blocks,
  };
  writeFileSync(new URL(`./recorded/${name}.json`, import.meta.url), JSON.stringify(out, null, 1).replace(/^ +/gm, '').replace(/\n/g, '') + '\n');
  console.log(name, blocks.map((block) => `${block.block}:${block.networks.length}`).join(' '));
}
