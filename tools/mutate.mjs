#!/usr/bin/env node
// Mutation testing: seeds one fault at a time and lists those that no test notices.
//   tools/mutate.mjs --files sim/kernel/output_analysis.cpp --tests kernel,theory --count 20 --seed 1
// Works in the tree it stands in: each fault is built with the release preset, tested, and taken back (also after Ctrl-C).
// A fault that does not compile, or that the compiler turns into the same object, is not counted.
import {execFileSync, spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
const option = (name, otherwise) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? otherwise : process.argv[at + 1];
};
const files = (option('files', '') || '').split(',').filter(f => f !== '');
const tests = (option('tests', '') || '').split(',').filter(t => t !== '');
const count = Number(option('count', '20'));
let dice = BigInt(option('seed', '1'));
if (files.length === 0 || tests.length === 0 || !(count > 0)) {
  console.error('mutate: --files A.cpp,B.cpp --tests kernel,shop are needed (see the head of this file)');
  process.exit(2);
}
for (const file of files)
  if (!existsSync(join(root, file))) {
    console.error(`mutate: there is no ${file}`);
    process.exit(2);
  }
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
  [/\btrue\b/g, ['false']], [/\bfalse\b/g, ['true']], [/\b1\b(?![.'])/g, ['2']], [/\b0\b(?![.'x])/g, ['1']], [/\b2\b(?![.'])/g, ['3']]
];

function faults() {
  const all = [];
  for (const file of files) {
    readFileSync(join(root, file), 'utf8').split('\n').forEach((line, k) => {
      const code = line.replace(/\/\/.*$/, '');
      if (/^\s*(#|\*|static_assert|namespace|using|template)/.test(code) || code.includes('"')) return;
      for (const [pattern, replacements] of slips)
        for (const match of code.matchAll(pattern))
          for (const to of replacements)
            all.push({file, line: k, column: match.index, from: match[0], to});
    });
  }
  return all;
}

const targets = tests.map(t => `test_${t}`);
const build = () => spawnSync('cmake', ['--build', '--preset', 'release', '--target', ...targets], {cwd: root, encoding: 'utf8'});
const objectsOf = () => targets.map(t => createHash('sha256').update(readFileSync(join(root, 'build/release', t))).digest('hex')).join();
function passes() {
  for (const target of targets) {
    const run = spawnSync(join(root, 'build/release', target), ['-a', '-w', 'NoTests'],
                          {cwd: root, env: {...process.env, RC_PARAMS: 'seed=1'}, timeout: 300_000, stdio: 'ignore'});
    if (run.status !== 0) return false;
  }
  return true;
}

if (execFileSync('git', ['status', '--porcelain', '--', ...files], {cwd: root, encoding: 'utf8'}) !== '') {
  console.error('mutate: commit the files first, they are changed in place');
  process.exit(2);
}
if (build().status !== 0 || !passes()) {
  console.error('mutate: the tests must pass before faults are seeded');
  process.exit(1);
}
const whole = objectsOf();
const all = faults();
let undo = () => {};
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => { undo(); process.exit(130); });

let seeded = 0;
let noticed = 0;
const survivors = [];
while (seeded < count && all.length > 0) {
  const fault = all.splice(roll(all.length), 1)[0];
  const path = join(root, fault.file);
  const text = readFileSync(path, 'utf8');
  undo = () => writeFileSync(path, text);
  const lines = text.split('\n');
  const line = lines[fault.line];
  lines[fault.line] = line.slice(0, fault.column) + fault.to + line.slice(fault.column + fault.from.length);
  writeFileSync(path, lines.join('\n'));
  const compiled = build().status === 0;
  if (compiled && objectsOf() !== whole) {
    ++seeded;
    const where = `${fault.file}:${fault.line + 1}: ${line.trim()}   ->   ${lines[fault.line].trim()}`;
    if (passes()) {
      survivors.push(where);
      console.log(`NOT NOTICED ${where}`);
    } else {
      ++noticed;
      console.log(`noticed     ${where}`);
    }
  }
  undo();
  undo = () => {};
}
build();
console.log(`${seeded} faults seeded, ${noticed} noticed, ${survivors.length} not`);
process.exit(survivors.length === 0 ? 0 : 1);
