#!/usr/bin/env node
// Mutation testing: seeds one fault at a time and lists those that no test notices.
//   tools/mutate.mjs --files sim/kernel/resource.cpp,sim/kernel/store.h --test kernel --test theory:~[long]
//                    --count 40 --seed 1 --results build/mutants.json
//   tools/mutate.mjs --results build/mutants.json --again     the survivors once more, after new tests
//   tools/mutate.mjs --results build/mutants.json --report    a table per file and the survivors, as markdown
//
//   --files A,B     sources in which faults are seeded; a folder means all .h and .cpp below it
//   --test NAME[:FILTER]  a test program and Catch2's filter for it; the quickest first, may be given again. A fault counts
//                   as noticed by the first program that fails, ends by a signal, or takes ten times its undisturbed time
//   --count N       how many faults that compile are wanted of these files, those in the results included (default 20)
//   --seed N        the order in which faults are drawn (default 1)
//   --results FILE  every verdict, written after each fault; a run that was stopped goes on where it stopped
//   --tree DIR      the clone in which it builds, made and updated when needed (default build/mutation): the tree with this
//                   script is never changed, and faults are seeded in what is committed
//   --except FILE   lines "file: from -> to" of faults that change nothing anybody could see, each under a # line with the
//                   reason: they are told apart from survivors (default tools/equivalent-mutants.txt)
// A fault that does not compile, or from which the compiler makes the same program, is not counted.
import {execFileSync, spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, readdirSync, readFileSync, renameSync, statSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
function fail(text) {
  console.error(`mutate: ${text}`);
  process.exit(2);
}

const options = {files: [], test: [], count: '20', seed: '1', results: '', tree: join(root, 'build/mutation'),
                 except: join(root, 'tools/equivalent-mutants.txt')};
const switches = {again: false, report: false};
for (let k = 2; k < process.argv.length; ++k) {
  const name = process.argv[k].replace(/^--/, '');
  if (name in switches) switches[name] = true;
  else if (!(name in options) || k + 1 === process.argv.length) fail(`unknown or incomplete option ${process.argv[k]} (see the head of the script)`);
  else if (name === 'files') options.files.push(...process.argv[++k].split(','));
  else if (name === 'test') options.test.push(process.argv[++k]);
  else options[name] = process.argv[++k];
}
const count = Number(options.count);
if (!(count > 0)) fail(`--count is ${options.count}, must be a number above 0`);
const results = options.results !== '' && existsSync(options.results) ? JSON.parse(readFileSync(options.results, 'utf8')) : [];
function keep() {
  if (options.results === '') return;
  writeFileSync(`${options.results}.new`, JSON.stringify(results, null, 1) + '\n');
  renameSync(`${options.results}.new`, options.results);
}

const equivalent = new Set(existsSync(options.except)
  ? readFileSync(options.except, 'utf8').split('\n').filter(l => l !== '' && !l.startsWith('#')) : []);
const wordsOf = f => `${f.file}: ${f.before} -> ${f.after}`;
const isSurvivor = f => f.verdict === 'survived' && !equivalent.has(wordsOf(f));
const isCounted = f => f.verdict !== 'not compiled' && f.verdict !== 'same program';

if (switches.report) {
  const rows = new Map();
  for (const f of results.filter(isCounted)) {
    const row = rows.get(f.file) ?? {seeded: 0, noticed: 0, equivalent: 0};
    ++row.seeded;
    if (f.verdict === 'noticed') ++row.noticed;
    else if (equivalent.has(wordsOf(f))) ++row.equivalent;
    rows.set(f.file, row);
  }
  console.log('| file | seeded | noticed | equivalent | survived |\n|---|---|---|---|---|');
  const sum = {seeded: 0, noticed: 0, equivalent: 0};
  const line = (name, r) => console.log(`| ${name} | ${r.seeded} | ${r.noticed} | ${r.equivalent} | ${r.seeded - r.noticed - r.equivalent} |`);
  for (const [file, row] of [...rows].sort()) {
    line(file, row);
    for (const k of Object.keys(sum)) sum[k] += row[k];
  }
  line('all', sum);
  const left = results.filter(isSurvivor);
  if (left.length > 0) console.log();
  for (const f of left) console.log(`- \`${f.file}:${f.line}\`: \`${f.before}\` -> \`${f.after}\``);
  process.exit(0);
}

if (!switches.again && options.files.length === 0) fail('--files is missing (see the head of the script)');
if (options.test.length === 0 && !switches.again) fail('--test is missing (see the head of the script)');

// ------------------------------------------------------------------------------------------ the tree
const tree = resolve(options.tree);
const run = (program, args, more = {}) => spawnSync(program, args, {cwd: tree, encoding: 'utf8', maxBuffer: 1 << 26, ...more});
const head = execFileSync('git', ['rev-parse', 'HEAD'], {cwd: root, encoding: 'utf8'}).trim();
if (!existsSync(tree)) execFileSync('git', ['clone', '--quiet', '--shared', '--no-checkout', root, tree]);
if (existsSync(join(tree, '.git')) === false) fail(`${tree} is not a tree of this script`);
for (const step of [['fetch', '--quiet', root, 'HEAD'], ['reset', '--quiet', '--hard', head]])
  if (run('git', step).status !== 0) fail(`git ${step.join(' ')} in ${tree} does not work`);

function sourcesOf(path) {
  const full = join(tree, path);
  if (!existsSync(full)) fail(`there is no committed ${path}`);
  if (!statSync(full).isDirectory()) return [path];
  return readdirSync(full, {recursive: true}).map(String).filter(n => /\.(h|cpp)$/.test(n)).sort().map(n => join(path, n));
}
const files = options.files.flatMap(sourcesOf);

// ---------------------------------------------------------------------------------------- the faults
let dice = BigInt(options.seed);
function roll(below) {  // splitmix64
  const mask = (1n << 64n) - 1n;
  dice = (dice + 0x9e3779b97f4a7c15n) & mask;
  let z = dice;
  z = ((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n) & mask;
  z = ((z ^ (z >> 27n)) * 0x94d049bb133111ebn) & mask;
  return Number(((z ^ (z >> 31n)) & mask) % BigInt(below));
}

// What slips in by a tired hand: [pattern, replacements].
const slips = [
  [/ \+ /g, [' - ']], [/ - /g, [' + ']], [/ \* /g, [' / ']], [/ \/ /g, [' * ']],
  [/ < /g, [' <= ', ' > ']], [/ <= /g, [' < ']], [/ > /g, [' >= ', ' < ']], [/ >= /g, [' > ']],
  [/ == /g, [' != ']], [/ != /g, [' == ']], [/ && /g, [' || ']], [/ \|\| /g, [' && ']],
  [/\+\+/g, ['--']], [/ \+= /g, [' -= ', ' = ']], [/ -= /g, [' += ']],
  [/\bstd::max\b/g, ['std::min']], [/\bstd::min\b/g, ['std::max']], [/\bstd::exp\b/g, ['std::log']],
  [/\bstd::sin\b/g, ['std::cos']], [/\bstd::cos\b/g, ['std::sin']], [/\bstd::sqrt\b/g, ['std::abs']],
  [/\btrue\b/g, ['false']], [/\bfalse\b/g, ['true']], [/\b1\b(?![.'])/g, ['2']], [/\b0\b(?![.'x])/g, ['1']], [/\b2\b(?![.'])/g, ['3']],
  // A whole statement is forgotten: a call or an assignment on a line of its own.
  [/^\s+(?!return\b|throw\b|else\b|const\b|case\b|break\b|continue\b|using\b)[a-z_][\w.:>\[\]-]*(\(.*\)| [-+*|]?= .*);\s*$/g, [';']]
];

function faults() {
  const all = [];
  for (const file of files) {
    readFileSync(join(tree, file), 'utf8').split('\n').forEach((line, k) => {
      const code = line.replace(/\/\/.*$/, '');
      if (/^\s*(#|\*|static_assert|namespace|using|template)/.test(code) || code.includes('"')) return;
      for (const [pattern, replacements] of slips)
        for (const match of code.matchAll(pattern))
          for (const to of replacements)
            all.push({file, line: k + 1, column: match.index, from: match[0], to});
      for (const match of code.matchAll(/\bif \(/g)) {  // the condition the other way round
        let depth = 0;
        let end = match.index + match[0].length - 1;
        for (; end < code.length; ++end) {
          if (code[end] === '(') ++depth;
          if (code[end] === ')' && --depth === 0) break;
        }
        const from = code.slice(match.index, end + 1);
        if (end < code.length && !from.includes(';')) all.push({file, line: k + 1, column: match.index, from, to: `if (!${from.slice(3)})`});
      }
    });
  }
  for (let k = all.length - 1; k > 0; --k) {
    const other = roll(k + 1);
    [all[k], all[other]] = [all[other], all[k]];
  }
  return all;
}

// --------------------------------------------------------------------------------- building and testing
const testsOf = texts => texts.map(t => {
  const colon = t.indexOf(':');
  return colon < 0 ? {name: t, filter: []} : {name: t.slice(0, colon), filter: [t.slice(colon + 1)]};
});
const build = tests => run('ninja', ['-C', join(tree, 'build/release'), ...tests.map(t => `test_${t.name}`)]).status === 0;
const programOf = name => join(tree, 'build/release', name);
const programsOf = tests => tests.map(t => `test_${t.name}`).concat(tests.some(t => /^(e2e|faults)$/.test(t.name)) ? ['verstat'] : []);
const hashOf = tests => programsOf(tests).map(p => createHash('sha256').update(readFileSync(programOf(p))).digest('hex')).join();
const limits = new Map();  // ms per test
function noticedBy(tests) {
  for (const test of tests) {
    const begin = Date.now();
    // A fault may eat memory without end.
    const command = `ulimit -v 6000000; exec "$0" "$@"`;
    const outcome = run('bash', ['-c', command, programOf(`test_${test.name}`), '--abort', '-w', 'NoTests', ...test.filter],
                        {env: {...process.env, RC_PARAMS: 'seed=1'}, timeout: limits.get(test) ?? 600_000, killSignal: 'SIGKILL'});
    if (outcome.error?.code === 'ETIMEDOUT') return `${test.name} (no end)`;
    if (outcome.signal !== null || outcome.status > 127) return `${test.name} (crash)`;
    if (outcome.status !== 0) return test.name;
    if (!limits.has(test)) limits.set(test, 10_000 + 10 * (Date.now() - begin));
  }
  return '';
}

const sets = new Map();  // a set of tests that passes undisturbed, by its words
function prepared(texts) {
  const key = texts.join(' ');
  if (!sets.has(key)) {
    const tests = testsOf(texts);
    if (!build(tests)) fail(`the undisturbed tree does not build (ninja -C ${tree}/build/release)`);
    const failing = noticedBy(tests);
    if (failing !== '') fail(`${failing} must pass before faults are seeded`);
    sets.set(key, {tests, whole: hashOf(tests)});
  }
  return sets.get(key);
}

let undo = () => {};
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => { undo(); process.exit(130); });
function judge(fault, texts) {
  const {tests, whole} = prepared(texts);
  const path = join(tree, fault.file);
  const text = readFileSync(path, 'utf8');
  undo = () => writeFileSync(path, text);
  const lines = text.split('\n');
  const before = lines[fault.line - 1];
  const after = before.slice(0, fault.column) + fault.to + before.slice(fault.column + fault.from.length);
  lines[fault.line - 1] = after;
  writeFileSync(path, lines.join('\n'));
  const answer = {...fault, before: before.trim(), after: after.trim(), tests: texts};
  if (!build(tests)) answer.verdict = 'not compiled';
  else if (hashOf(tests) === whole) answer.verdict = 'same program';
  else {
    const by = noticedBy(tests);
    answer.verdict = by === '' ? 'survived' : 'noticed';
    if (by !== '') answer.by = by;
  }
  undo();
  undo = () => {};
  if (isCounted(answer)) {
    const word = answer.verdict === 'noticed' ? `noticed by ${answer.by}` : equivalent.has(wordsOf(answer)) ? 'equivalent' : 'NOT NOTICED';
    console.log(`${word.padEnd(24)} ${fault.file}:${fault.line}: ${answer.before}   ->   ${answer.after}`);
  }
  return answer;
}

if (run('cmake', ['--preset', 'release', '-DVERSTAT_WEB=OFF', '-DVERSTAT_BENCH=OFF', '-DVERSTAT_MPI=OFF']).status !== 0)
  fail(`cmake --preset release in ${tree} does not work`);
if (switches.again) {
  for (let k = 0; k < results.length; ++k) {
    const f = results[k];
    if (!isSurvivor(f)) continue;
    // Lines may have moved since: the fault belongs to the same words.
    const lines = readFileSync(join(tree, f.file), 'utf8').split('\n');
    const places = lines.flatMap((l, at) => l.trim() === f.before ? [at + 1] : []);
    const line = places.sort((a, b) => Math.abs(a - f.line) - Math.abs(b - f.line))[0];
    if (line === undefined) {
      console.log(`no longer there          ${wordsOf(f)}`);
      results.splice(k--, 1);
    } else {
      const {file, column, from, to} = f;
      results[k] = judge({file, line, column, from, to}, options.test.length > 0 ? options.test : f.tests);
    }
    keep();
  }
} else {
  const same = (a, b) => a.file === b.file && a.line === b.line && a.column === b.column && a.from === b.from && a.to === b.to;
  const ours = () => results.filter(f => files.includes(f.file) && isCounted(f)).length;
  for (const fault of faults()) {
    if (ours() >= count) break;
    if (results.some(f => same(f, fault))) continue;
    results.push(judge(fault, options.test));
    keep();
  }
}
const counted = results.filter(isCounted);
const noticed = counted.filter(f => f.verdict === 'noticed').length;
const left = counted.filter(isSurvivor).length;
console.log(`${counted.length} faults seeded, ${noticed} noticed, ${counted.length - noticed - left} equivalent, ${left} not noticed`);
process.exit(left === 0 ? 0 : 1);
