#!/usr/bin/env node
// The parts that Verstat is made of, read from packages.txt, dpkg and package-lock.json.
//   tools/sbom.mjs                  a CycloneDX 1.5 bill of materials on standard output
//   tools/sbom.mjs --licences       the same as the table of docs/licences.md
//   tools/sbom.mjs --check          fails when docs/licences.md lacks a part or names one that is gone
import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync, realpathSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
const read = name => readFileSync(join(root, name), 'utf8');

// What ends up in the program; everything else builds or tests it.
const linked = new Set(['libboost1.81-dev', 'libnlopt-cxx-dev', 'libeigen3-dev', 'libsqlite3-dev', 'libsqlitecpp-dev',
                        'nlohmann-json3-dev', 'libvalijson-dev', 'libcli11-dev', 'libfmt-dev', 'libopenmpi-dev']);
const bundled = new Set(['echarts', 'zrender', 'tslib']);

// Short names of the licences in a Debian copyright file: of the files of the package, not of its packaging.
function debianLicence(name) {
  const file = `/usr/share/doc/${name}/copyright`;
  if (!existsSync(file)) return 'not installed here';
  const paragraphs = readFileSync(realpathSync(file), 'utf8').split(/\n\s*\n/);
  const names = new Set();
  for (const p of paragraphs) {
    const files = p.match(/^Files:\s*([^\n]*)/m);
    const licence = p.match(/^License:\s*([^\n]+)/m);
    if (files && licence && !files[1].trim().startsWith('debian/')) names.add(licence[1].trim());
  }
  if (names.size === 0) return `see ${file}`;
  const all = [...names].sort();
  return all.length > 6 ? `${all.slice(0, 6).join(', ')} and others: ${file}` : all.join(', ');
}

function debianVersion(name) {
  try {
    const answer = execFileSync('dpkg-query', ['-W', '-f', '${db:Status-Status} ${Version}', name],
                                {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
    const [status, version] = answer.split(' ');
    return status === 'installed' ? version : null;
  } catch {
    return null;
  }
}

function parts() {
  const all = [];
  for (const line of read('packages.txt').split('\n')) {
    const name = line.replace(/#.*/, '').trim();
    if (name === '') continue;
    const version = debianVersion(name);
    all.push({name, version, licence: debianLicence(name), use: linked.has(name) ? 'linked' : 'build and test',
              purl: `pkg:deb/debian/${name}${version === null ? '' : '@' + encodeURIComponent(version)}`});
  }
  const lock = JSON.parse(read('web-ui/client/package-lock.json'));
  for (const [path, p] of Object.entries(lock.packages)) {
    if (path === '') continue;
    const name = path.replace(/^.*node_modules\//, '');
    const [hashName, hash] = (p.integrity ?? '').split('-');
    all.push({name, version: p.version, licence: p.license ?? 'not stated',
              use: bundled.has(name) ? 'in the pages' : 'build and test',
              purl: `pkg:npm/${name.replace('@', '%40')}@${p.version}`,
              hash: hashName === 'sha512' ? Buffer.from(hash, 'base64').toString('hex') : null});
  }
  return all.sort((a, b) => (a.purl < b.purl ? -1 : a.purl > b.purl ? 1 : 0));
}

function cyclonedx() {
  const version = read('CMakeLists.txt').match(/project\(verstat VERSION ([0-9.]+)/)[1];
  return {
    bomFormat: 'CycloneDX', specVersion: '1.5', version: 1,
    metadata: {component: {type: 'application', name: 'verstat', version,
                           licenses: [{license: {id: 'Apache-2.0'}}]}},
    components: parts().map(p => ({
      type: 'library', 'bom-ref': p.purl, name: p.name, version: p.version ?? '', purl: p.purl,
      scope: p.use === 'build and test' ? 'excluded' : 'required',
      licenses: [{license: {name: p.licence}}],
      ...(p.hash ? {hashes: [{alg: 'SHA-512', content: p.hash}]} : {})
    }))
  };
}

function table() {
  const rows = parts().map(p => `| ${p.name} | ${p.use} | ${p.licence} |`);
  return [...new Set(rows)].join('\n');
}

function check() {
  const written = new Set(read('docs/licences.md').split('\n').filter(l => l.startsWith('| ') && !l.startsWith('| part'))
    .map(l => l.split('|')[1].trim()));
  const present = new Set(parts().map(p => p.name));
  const missing = [...present].filter(n => !written.has(n));
  const gone = [...written].filter(n => !present.has(n));
  for (const n of missing) console.error(`sbom: docs/licences.md lacks ${n} (tools/sbom.mjs --licences prints the table)`);
  for (const n of gone) console.error(`sbom: docs/licences.md names ${n}, which nothing uses`);
  process.exit(missing.length + gone.length === 0 ? 0 : 1);
}

const argument = process.argv[2];
if (argument === '--licences') console.log(table());
else if (argument === '--check') check();
else if (argument === undefined) console.log(JSON.stringify(cyclonedx(), null, 2));
else {
  console.error(`sbom: unknown argument ${argument}`);
  process.exit(2);
}
