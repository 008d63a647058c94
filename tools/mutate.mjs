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
//   --jobs N        faults at a time (default 2)
//   --except FILE   lines "file: from -> to" of faults that change nothing anybody could see, each under a # line with the
//                   reason: they are told apart from survivors (default tools/equivalent-mutants.txt)
// A fault that does not compile, or from which the compiler makes the same program, is not counted.
import {execFileSync, spawn, spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {dirname, join, relative, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
function fail(text) {
  console.error(`mutate: ${text}`);
  process.exit(2);
}

const options = {files: [], test: [], count: '20', seed: '1', jobs: '2', results: '', tree: join(root, 'build/mutation'),
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
const isCounted = f => f.verdict === 'noticed' || f.verdict === 'survived';

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
  [/\btrue\b/g, ['false']], [/\bfalse\b/g, ['true']], [/(?<![.'])\b1\b(?![.'])/g, ['2']], [/(?<![.'])\b0\b(?![.'x])/g, ['1']], [/(?<![.'])\b2\b(?![.'])/g, ['3']],
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
const release = join(tree, 'build/release');
const programsOf = test => test.name === 'e2e' ? ['test_e2e', 'verstat'] : [`test_${test.name}`];
const shell = (command, more = {}) => new Promise(done => {
  const child = spawn('bash', ['-c', command], {cwd: release, stdio: 'ignore', detached: true, ...more});
  let late = false;
  const end = () => { try { process.kill(-child.pid, 'SIGKILL'); } catch { /* it has ended by itself */ } };
  const timer = more.limit === undefined ? undefined : setTimeout(() => { late = true; end(); }, more.limit);
  running.add(end);
  child.on('close', (status, signal) => { clearTimeout(timer); running.delete(end); done({status, signal, late}); });
});
const running = new Set();
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => { running.forEach(end => end()); process.exit(130); });

// How each object is compiled and each program linked, from CMake and ninja.
const compiles = new Map();  // by object: {source, command}
const links = new Map();     // by program
const dependents = new Map();  // by header or source: objects
function readBuild() {
  for (const entry of JSON.parse(readFileSync(join(release, 'compile_commands.json'), 'utf8'))) {
    const command = entry.command.slice(entry.command.indexOf('/c++ ') + 5);
    compiles.set(entry.output ?? / -o (\S+)/.exec(command)[1], {source: entry.file, command});
  }
  let object = '';
  for (const line of run('ninja', ['-C', release, '-t', 'deps']).stdout.split('\n')) {
    const begin = /^(\S+): #deps/.exec(line);
    if (begin) object = begin[1];
    else if (line.startsWith('    ')) {
      const path = relative(tree, resolve(release, line.trim()));
      if (!path.startsWith('..')) dependents.set(path, [...(dependents.get(path) ?? []), object]);
    }
  }
}
function linkOf(program) {
  if (!links.has(program)) {
    const command = run('ninja', ['-C', release, '-t', 'commands', program]).stdout.trim().split('\n').at(-1);
    links.set(program, command);
  }
  return links.get(program);
}
// Objects that a program is made of, those of its libraries included.
const libraryOf = object => /CMakeFiles\/verstat_(\w+)\.dir\//.exec(object)?.[1];
const isPart = (object, link) => link.includes(` ${object} `) || link.includes(` libverstat_${libraryOf(object)}.a `);

const limits = new Map();  // ms per test
/// The first of the tests that fails with the programs in a folder; '' when none does.
async function noticedBy(tests, folder) {
  for (const test of tests) {
    const begin = Date.now();
    const words = ['--abort', '-w', 'NoTests', ...test.filter].map(w => `'${w}'`).join(' ');
    // A fault may eat memory without end.
    const outcome = await shell(`ulimit -v 6000000; exec ${join(folder, `test_${test.name}`)} ${words}`,
      {cwd: tree, env: {...process.env, RC_PARAMS: 'seed=1', VERSTAT_PROGRAM: join(folder, 'verstat')}, limit: limits.get(test) ?? 900_000});
    if (outcome.late) return `${test.name} (no end)`;
    if (outcome.signal !== null || outcome.status > 127) return `${test.name} (crash)`;
    if (outcome.status !== 0) return test.name;
    if (!limits.has(test)) limits.set(test, 20_000 + 10 * (Date.now() - begin));
  }
  return '';
}

const sets = new Map();  // sets of tests that pass undisturbed, by their words
async function prepared(texts) {
  const key = texts.join(' ');
  if (!sets.has(key)) {
    const tests = testsOf(texts);
    // Whatever is left over from an earlier commit of the tree is built anew.
    if (run('ninja', ['-C', release, ...tests.flatMap(programsOf)]).status !== 0)
      fail(`the undisturbed tree does not build (ninja -C ${release})`);
    readBuild();
    const failing = await noticedBy(tests, release);
    if (failing !== '') fail(`${failing} must pass before faults are seeded`);
    sets.set(key, tests);
  }
  return sets.get(key);
}

/// Compiles the objects that depend on a file against this text of it; their hashes, or '' when one does not compile.
async function compile(file, text, objects, folder) {
  const changed = join(folder, 'source', file);
  mkdirSync(dirname(changed), {recursive: true});
  writeFileSync(changed, text);
  const hash = createHash('sha256');
  for (const object of objects) {
    const {source, command} = compiles.get(object);
    const made = join(folder, object.replaceAll('/', '_'));
    const plain = command.replace(/ -MD -MT \S+ -MF \S+/, '').replace(/ -o \S+ -c \S+/, '');
    const from = relative(tree, source) === file ? changed : source;
    const {status} = await shell(`exec c++ -I${join(folder, 'source')} ${plain} -o ${made} -c ${from}`);
    if (status !== 0) return '';
    hash.update(readFileSync(made));
  }
  return hash.digest('hex');
}

const plainHashes = new Map();
async function judge(fault, texts, folder) {
  const tests = sets.get(texts.join(' '));
  const programs = tests.flatMap(programsOf);
  const objects = [...new Set(dependents.get(fault.file) ?? [])]
    .filter(o => compiles.has(o) && programs.some(p => isPart(o, linkOf(p))));
  const text = readFileSync(join(tree, fault.file), 'utf8');
  const lines = text.split('\n');
  const before = lines[fault.line - 1];
  const after = before.slice(0, fault.column) + fault.to + before.slice(fault.column + fault.from.length);
  lines[fault.line - 1] = after;
  const answer = {...fault, before: before.trim(), after: after.trim(), tests: texts};
  rmSync(folder, {recursive: true, force: true});
  if (!plainHashes.has(fault.file)) plainHashes.set(fault.file, compile(fault.file, text, objects, `${folder}-plain`));
  const plain = await plainHashes.get(fault.file);
  const hash = await compile(fault.file, lines.join('\n'), objects, folder);
  if (objects.length === 0) answer.verdict = 'not in these programs';
  else if (hash === '') answer.verdict = 'not compiled';
  else if (hash === plain) answer.verdict = 'same program';
  else {
    for (const program of programs) {
      let link = linkOf(program).replace(` -o ${program} `, ` -o ${join(folder, program)} `);
      for (const object of objects.filter(o => isPart(o, linkOf(program)))) {
        const made = join(folder, object.replaceAll('/', '_'));
        // What stands before the libraries is taken instead of the same object in them.
        link = link.includes(` ${object} `) ? link.replace(` ${object} `, ` ${made} `) : link.replace(/ lib\w+\.a /, ` ${made}$&`);
      }
      const {status} = await shell(link);
      if (status !== 0) answer.verdict = 'not compiled';
    }
    if (answer.verdict === undefined) {
      const by = await noticedBy(tests, folder);
      answer.verdict = by === '' ? 'survived' : 'noticed';
      if (by !== '') answer.by = by;
    }
  }
  if (isCounted(answer)) {
    const word = answer.verdict === 'noticed' ? `noticed by ${answer.by}` : equivalent.has(wordsOf(answer)) ? 'equivalent' : 'NOT NOTICED';
    console.log(`${word.padEnd(24)} ${fault.file}:${fault.line}: ${answer.before}   ->   ${answer.after}`);
  }
  return answer;
}

/// Several at a time, each in a folder of its own.
async function inParallel(work) {
  const queue = work[Symbol.iterator]();
  await Promise.all(Array.from({length: Number(options.jobs)}, async (_, lane) => {
    for (let next = queue.next(); !next.done; next = queue.next()) await next.value(join(tree, `build/fault-${process.pid}-${lane}`));
  }));
  for (const name of readdirSync(join(tree, 'build')))
    if (name.startsWith(`fault-${process.pid}-`)) rmSync(join(tree, 'build', name), {recursive: true});
}

if (run('cmake', ['--preset', 'release', '-DVERSTAT_WEB=OFF', '-DVERSTAT_BENCH=OFF', '-DVERSTAT_MPI=OFF']).status !== 0)
  fail(`cmake --preset release in ${tree} does not work`);
if (switches.again) {
  const survivors = results.filter(isSurvivor);
  for (const f of survivors) await prepared(options.test.length > 0 ? options.test : f.tests);
  await inParallel(survivors.map(f => async folder => {
    // Lines may have moved since: the fault belongs to the same words.
    const lines = readFileSync(join(tree, f.file), 'utf8').split('\n');
    const places = lines.flatMap((l, at) => l.trim() === f.before ? [at + 1] : []);
    const line = places.sort((a, b) => Math.abs(a - f.line) - Math.abs(b - f.line))[0];
    const {file, column, from, to} = f;
    const answer = line === undefined ? undefined : await judge({file, line, column, from, to}, options.test.length > 0 ? options.test : f.tests, folder);
    const at = results.indexOf(f);
    if (answer === undefined) {
      console.log(`no longer there          ${wordsOf(f)}`);
      results.splice(at, 1);
    } else {
      results[at] = answer;
    }
    keep();
  }));
} else {
  await prepared(options.test);
  const same = (a, b) => a.file === b.file && a.line === b.line && a.column === b.column && a.from === b.from && a.to === b.to;
  const ours = () => results.filter(f => files.includes(f.file) && isCounted(f)).length;
  function* work() {
    for (const fault of faults()) {
      if (ours() >= count) return;
      if (results.some(f => same(f, fault))) continue;
      yield async folder => { results.push(await judge(fault, options.test, folder)); keep(); };
    }
  }
  await inParallel(work());
}
const counted = results.filter(isCounted);
const noticed = counted.filter(f => f.verdict === 'noticed').length;
const left = counted.filter(isSurvivor).length;
console.log(`${counted.length} faults seeded, ${noticed} noticed, ${counted.length - noticed - left} equivalent, ${left} not noticed`);
process.exit(left === 0 ? 0 : 1);
