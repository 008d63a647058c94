// Journeys through the pages in a real browser against a real server and database:
//   node journeys.mjs --program verstat --chromium /usr/bin/chromium --scenarios scenarios/gallery --images DIR
// Makes its own database in a temporary folder, starts the server on a free port, ends both. Exit code 1 and a list
// of what went wrong when anything does. --only WORDS (a regular expression) leaves the others out; some build on those before.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';

const { values: options } = parseArgs({
  options: { program: { type: 'string' }, chromium: { type: 'string' }, scenarios: { type: 'string' }, images: { type: 'string' }, only: { type: 'string' } },
});
const folder = mkdtempSync(join(tmpdir(), 'verstat-pages-'));
const db = join(folder, 'journeys.db');
const verstat = (...args) => execFileSync(options.program, [...args, '--db', db], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
const json = (...args) => JSON.parse(verstat('runs', '--json', ...args));

function startServer(...args) {
  const server = spawn(options.program, ['serve', '--db', db, '--port', '0', ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
  return new Promise((resolve, reject) => {
    let log = '';
    server.stdout.on('data', (data) => {
      log += data;
      if (log.includes('\n')) resolve({ server, url: log.trim() });
    });
    server.stderr.on('data', (data) => (log += data));
    server.on('exit', (code) => reject(new Error(`verstat serve ended with ${code}: ${log}`)));
  });
}

const ended = (server) => new Promise((resolve) => server.once('exit', (code, signal) => resolve(code ?? signal)));

let failures = 0;
async function journey(name, body) {
  if (options.only && !new RegExp(options.only).test(name)) return;
  const start = Date.now();
  try {
    await body();
    console.log(`ok    ${name} (${Date.now() - start} ms)`);
  } catch (error) {
    failures += 1;
    console.log(`FAIL  ${name}: ${error.stack ?? error}`);
  }
}

// Two digits of the uncertainty, as the command line prints: written here again, so that it is a second opinion.
function printed(kpi, scale = 1) {
  const half = kpi.half_width_95 * scale;
  const digits = Math.max(0, 1 - Math.floor(Math.log10(half)));
  return { mean: (kpi.mean * scale).toFixed(digits), half: `± ${half.toFixed(digits)}` };
}
// With a separator of thousands, as pages print it.
function printedThousands(kpi) {
  const { mean, half } = printed(kpi);
  const group = (x) => x.replace(/\B(?=(\d{3})+(?!\d))/g, ',');
  return `${group(mean)} ${half}`;
}
const plain = (text) => text.replace(/,/g, '');

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
async function accessible(page, where) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => globalThis.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa'] }));
  const grave = found.violations.filter((v) => v.impact === 'serious' || v.impact === 'critical');
  assert.deepEqual(grave.map((v) => `${where}: ${v.id}: ${v.nodes.map((n) => n.html.slice(0, 160)).join(' | ')}`), []);
}

/** Two machines without room before them, passed in opposite directions: they come to hold parts for each other. */
const CROSSING = (machine, operation, part) => ({
  name: 'Crossing', simulation: { horizon_min: 50000, replications: 4, seed: '3' },
  machines: [machine('lathe'), machine('mill')],
  operations: [operation('turn a', 'lathe'), operation('mill a', 'mill'), operation('mill b', 'mill'), operation('turn b', 'lathe')],
  stores: [{ name: 'out' }],
  parts: [part('a', ['turn a', 'mill a']), part('b', ['mill b', 'turn b'])],
});

let current;
let browser;
try {
  verstat('run', join(options.scenarios, 'heavy-lathe.json'));
  verstat('run', join(options.scenarios, 'heavy-lathe-treated.json'));
  verstat('optimize', join(options.scenarios, 'heavy-lathe.study.json'));
  current = await startServer();
  browser = await chromium.launch({
    executablePath: options.chromium,
    args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--disable-dev-shm-usage'],
  });
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: 'en-GB', timezoneId: 'Europe/Kyiv', acceptDownloads: true });
  const page = await context.newPage();
  page.setDefaultTimeout(15_000);
  const complaints = [];
  const outside = [];
  const { origin } = new URL(current.url);
  page.on('console', (m) => m.type() === 'error' && complaints.push(m.text()));
  page.on('pageerror', (e) => complaints.push(String(e)));
  page.on('request', (r) => !r.url().startsWith(origin) && !/^(data|blob):/.test(r.url()) && outside.push(r.url()));
  // A page stays until the next one has been made: what is read afterwards must be of the next one.
  const open = async (hash) => {
    const to = `${origin}/${hash}`;
    if (page.url() === to) await page.reload();
    else {
      await page.evaluate(() => document.querySelector('main > *')?.setAttribute('data-left', ''));
      await page.goto(to);
    }
    await page.waitForFunction(() => document.querySelector('main h1, main h2') && !document.querySelector('main > [data-left]'));
  };
  const charts = async (count) => page.waitForFunction((n) => document.querySelectorAll('.chart[data-drawn]').length >= n, count);
  /** The window as it stands, or one part of the page. */
  const picture = async (name, part) => {
    if (!options.images) return;
    mkdirSync(options.images, { recursive: true });
    if (!part) await page.evaluate(() => scrollTo(0, 0));
    writeFileSync(join(options.images, `${name}.png`), await (part ? page.locator(part).first() : page).screenshot());
  };

  await journey('home lists runs and studies, the last finding on top', async () => {
    await open('');
    const study = json('--study', '1');
    assert.equal(await page.textContent('.finding .words'), study.result.words.replaceAll('+-', '±'));
    assert.equal(await page.locator('section:has(#run-search) tbody tr').count(), 4);
    await accessible(page, 'home');
    await picture('home');
  });

  await journey('the numbers of a run are those of verstat runs --json', async () => {
    await page.click('tbody th a[href^="#/runs/"]');
    await page.waitForSelector('#tile-cost');
    const id = Number(/runs\/(\d+)/.exec(page.url())?.[1]);
    assert.ok(id > 0, page.url());
    const run = json('--run', String(id));
    const kpi = (name) => run.kpis.find((k) => k.name === name);
    const tile = async (which) => ({ mean: plain(await page.textContent(`#tile-${which} .value`)), half: plain(await page.textContent(`#tile-${which} .half`)) });
    assert.deepEqual(await tile('cost'), printed(kpi('cost_per_part')));
    assert.deepEqual(await tile('throughput'), printed(kpi('throughput_per_h')));
    const lowest = run.kpis.filter((k) => /^machine\/.*\/availability$/.test(k.name)).sort((a, b) => a.mean - b.mean)[0];
    assert.deepEqual(await tile('availability'), printed(lowest, 100));
    assert.deepEqual(await tile('failures'), printed(kpi('tool/roughing tool/failure_share'), 100));
    const answer = await (await fetch(`${origin}/api/v1/runs/${id}?replications=1`)).json();
    assert.deepEqual(answer, json('--run', String(id), '--all-replications'));
    await charts(2);
  });

  await journey('states add up to 100.0 %, the cost of a part to its total', async () => {
    await open('#/runs/1');
    await charts(2);
    const totals = await page.locator('section:has-text("machine’s time") tbody td:last-child').allTextContents();
    assert.deepEqual(totals, ['100.0', '100.0']);
    const rows = await page.locator('section:has-text("What a part costs") tbody tr').evaluateAll((all) => all.map((r) => ({ total: r.className === 'total', name: r.cells[0].textContent, amount: Math.round(100 * Number(r.cells[1].textContent)) })));
    const end = rows.findIndex((r) => r.total);
    assert.equal(rows.slice(0, end).reduce((sum, r) => sum + r.amount, 0), rows[end].amount);
    await accessible(page, 'run');
    await picture('run');
  });

  await journey('the indicator table can be filtered and saved as CSV', async () => {
    await page.fill('#kpi-filter', 'roughing failures');
    const names = await page.locator('section:has(#kpi-filter) tbody th').allTextContents();
    assert.ok(names.length > 0 && names.every((n) => n.includes('roughing')), String(names));
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('section:has(#kpi-filter) button:text-is("CSV")')]);
    const rows = readFileSync(await download.path(), 'utf8').trim().split('\r\n');
    const run = json('--run', '1');
    assert.equal(rows.length, run.kpis.length + 1);
    const [name, mean] = rows[1].split(',');
    assert.equal(name, run.kpis[0].name);
    assert.equal(Number(mean), run.kpis[0].mean);
  });

  await journey('a study shows its finding, plan and trials', async () => {
    await open('#/studies/1');
    const study = json('--study', '1');
    assert.equal(await page.textContent('#finding'), study.result.words.replaceAll('+-', '±'));
    const rows = await page.locator('section:has-text("Best plan against today") tbody tr').evaluateAll((all) => all.map((r) => [...r.cells].map((c) => c.textContent)));
    study.variables.forEach((v, k) => {
      assert.equal(rows[k][0], v.name);
      assert.equal(Number(rows[k][1]), Number(study.result.baseline.values[k].value.toPrecision(6)));
      assert.equal(Number(rows[k][2]), Number(study.result.best.values[k].value.toPrecision(6)));
    });
    const best = printed(study.result.best.simulated);
    assert.equal(rows.find((r) => r[0].includes('simulated'))[2], `${best.mean} ${best.half}`);
    await charts(2);
    await accessible(page, 'study');
    await picture('study');
  });

  await journey('two runs are compared by paired differences', async () => {
    await open('#/compare/1/2');
    const [a, b] = [json('--run', '1', '--all-replications'), json('--run', '2', '--all-replications')];
    const values = (run) => run.kpis.find((k) => k.name === 'cost_per_part').values;
    const mean = values(b).reduce((sum, v, r) => sum + v - values(a)[r], 0) / values(a).length;
    const row = await page.locator('tbody tr:has(code:text-is("cost_per_part"))').evaluate((r) => [...r.cells].map((c) => c.textContent));
    assert.ok(Math.abs(Number(row[3].split(' ± ')[0]) - mean) < 0.006, `${row[3]} against ${mean}`);
    assert.equal(row[5], 'lower');
    await accessible(page, 'compare');
  });

  await journey('ticking two runs on the home page leads to their comparison', async () => {
    await open('');
    await page.check('input[aria-label="Tick run 1 to compare it"]');
    await page.check('input[aria-label="Tick run 4 to compare it"]');
    await page.click('button:has-text("Compare")');
    await page.waitForSelector('h1:has-text("Run 4 against run 1")');
    await open('#/compare/1/2/4');
    await page.waitForSelector('h1:has-text("3 runs side by side")');
    const heads = await page.locator('thead th').allTextContents();
    assert.equal(heads.filter((x) => x.startsWith('Verdict')).length, 2);
    await accessible(page, 'compare three');
  });

  await journey('runs are searched, sorted, tagged and annotated', async () => {
    await open('#/runs/2');
    await page.click('summary:has-text("Note and tags")');
    await page.fill('#tags', 'night, treated');
    await page.fill('#note', 'Looks good');
    await page.click('#save-note');
    await page.waitForSelector('.annotation .tag:text-is("treated")');
    await accessible(page, 'note');
    await open('');
    await page.selectOption('#run-tag', 'treated');
    await page.waitForFunction(() => document.querySelectorAll('section:has(#run-search) tbody tr').length === 1);
    await page.selectOption('#run-tag', '');
    await page.fill('#run-search', 'LOOKS');
    await page.waitForFunction(() => document.querySelectorAll('section:has(#run-search) tbody tr').length === 1);
    await page.fill('#run-search', '');
    await page.waitForFunction(() => document.querySelectorAll('section:has(#run-search) tbody tr').length > 3);
    await page.click('button[data-sort=cost_per_part]');
    await page.waitForFunction(() => document.querySelector('button[data-sort=cost_per_part]')?.textContent.includes('▾'));
    const costs = await page.locator('section:has(#run-search) tbody tr td:nth-of-type(5)').allTextContents();
    const numbers = costs.map((c) => parseFloat(c));
    assert.deepEqual(numbers, [...numbers].sort((x, y) => y - x));
    await page.click('button[data-sort=id]');
  });

  await journey('an operation is planned as verstat plan does, moved, and refused beside its field', async () => {
    await open('#/operations/turning');
    await page.waitForSelector('#plan-time');
    const file = join(options.scenarios, 'operations', 'turning.json');
    const direct = (...args) => JSON.parse(execFileSync(options.program, ['plan', file, '--json', ...args], { encoding: 'utf8' }));
    const shown = async (name) => Number(plain(await page.textContent(`output[data-quantity="${name}"]`)));
    for (const q of direct().quantities) assert.equal(await shown(q.name), Number(q.value.toPrecision(6)), q.name);
    await accessible(page, 'operations');
    await page.fill('[data-pointer="/process/feed_mm_rev"] input[type=text]', '0,36');
    await page.press('[data-pointer="/process/feed_mm_rev"] input[type=text]', 'Tab');
    await page.waitForSelector('#plan-verdict.bad');
    for (const q of direct('--set', '/process/feed_mm_rev=0.36').quantities) assert.equal(await shown(q.name), Number(q.value.toPrecision(6)), q.name);
    await page.click('[data-pointer="/process/feed_mm_rev"] button');
    await page.waitForSelector('#sweep .chart[data-drawn]');
    await picture('operations');
    await page.fill('[data-pointer="/process/feed_mm_rev"] input[type=text]', '-1');
    await page.press('[data-pointer="/process/feed_mm_rev"] input[type=text]', 'Tab');
    await page.waitForSelector('[data-pointer="/process/feed_mm_rev"] > .bad:has-text("feed_mm_rev")');
  });

  await journey('a regime is changed, run and compared without leaving the browser', async () => {
    await open('#/scenario/run/1');
    await page.waitForSelector('#check.good');
    await accessible(page, 'scenario');
    await page.click('.shop-graph .node.machine');
    const count = '[data-pointer="/machines/0/count"] input[type=text]';
    await page.fill(count, '0');
    await page.press(count, 'Tab');
    await page.waitForSelector('[data-pointer="/machines/0/count"] > .bad:has-text("count")');
    await page.fill('[data-pointer="/machines/0/count"] input[type=text]', '2');
    await page.press('[data-pointer="/machines/0/count"] input[type=text]', 'Tab');
    await page.waitForSelector('#check.good');
    const scenario = JSON.parse(await page.inputValue('#scenario-text'));
    scenario.tools[0].strategy.gamma = 0.47;
    await page.fill('#scenario-text', JSON.stringify(scenario));
    await page.waitForSelector('#history code:text-is("/tools/0/strategy/gamma")');
    await page.waitForSelector('#check.good');
    await page.fill('#run-label', 'gamma 0.47');
    await page.click('#start-run');
    await page.waitForSelector('.job[data-state=finished]');
    await page.waitForSelector('#results a:has-text("Run 5")');
    const run = json('--run', '5');
    assert.equal(run.label, 'gamma 0.47');
    assert.deepEqual(run.changes, [{ pointer: '/tools/0/strategy/gamma', value: 0.47 }]);
    const again = JSON.parse(execFileSync(options.program, ['run', join(options.scenarios, 'heavy-lathe.json'), '--json', '--set', '/tools/0/strategy/gamma=0.47', '--db', join(folder, 'other.db')], { encoding: 'utf8' }));
    assert.deepEqual(run.kpis, again.kpis);
    const verdict = await page.locator('#results tbody tr:has-text("cost per part") .verdict').first().getAttribute('title');
    assert.equal(verdict, 'lower');
    await page.click('button:text-is("Undo")');
    await page.waitForSelector('text=As opened.');
    await picture('scenario');
  });

  await journey('a study is set up by ticking variables, started, and its answer opened', async () => {
    await open('#/scenario/gallery/heavy-lathe');
    await page.waitForSelector('#check.good');
    await page.click('button:text-is("Set up a study")');
    await page.click('.group[data-pointer="/tools"] > summary');
    await page.click('.group[data-pointer="/tools/0"] > summary');
    await page.click('.group[data-pointer="/tools/0/strategy"] > summary');
    await page.check('[data-pointer="/tools/0/strategy/gamma"] input[type=checkbox]');
    await page.waitForSelector('#study-setup tbody tr:has-text("gamma")');
    await page.fill('#study-replications', '5');
    await page.press('#study-replications', 'Tab');
    await accessible(page, 'study set-up');
    await page.click('#start-study');
    await page.click('a.to-study');
    await page.waitForSelector('#finding');
    const id = /studies\/(\d+)/.exec(page.url())[1];
    assert.equal(await page.textContent('#finding'), json('--study', id).result.words.replaceAll('+-', '±'));
  });

  await journey('a job under way is cancelled and leaves nothing behind', async () => {
    const before = json().runs?.length ?? json().length;
    await open('#/scenario/gallery/heavy-lathe');
    await page.waitForSelector('#check.good');
    const scenario = JSON.parse(await page.inputValue('#scenario-text'));
    scenario.simulation.replications = 100000;
    await page.fill('#scenario-text', JSON.stringify(scenario));
    await page.click('#start-run');
    await page.waitForSelector('.job[data-state=running]');
    await page.click('.job button:text-is("Cancel")');
    await page.waitForSelector('.job[data-state=cancelled]');
    assert.equal(json().runs?.length ?? json().length, before);
  });

  await journey('a run computed again is the same bit for bit, and says so', async () => {
    await open('#/runs/1');
    await page.click('#compute-again');
    await page.waitForSelector('[data-identical=true]');
    assert.match(await page.textContent('[data-identical]'), /Bit for bit the same: all [\d,]+ values/);
  });

  await journey('tables and charts are saved as CSV, JSON, PNG and SVG; the CSV gives the numbers back', async () => {
    await open('#/runs/1');
    await charts(2);
    const save = async (where, item) => {
      await page.click(`${where} summary:text-is("Save")`);
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(`${where} .save-items button:text-is("${item}")`)]);
      return readFileSync(await download.path());
    };
    const all = 'section:has(#kpi-filter) .with-save';
    const run = json('--run', '1');
    const rows = (await save(all, 'CSV for Excel (; and decimal comma)')).toString('utf8').replace('\uFEFF', '').trim().split('\r\n').map((r) => r.split(';'));
    assert.equal(rows.length, run.kpis.length + 1);
    run.kpis.forEach((k, i) => assert.equal(Number(rows[i + 1][1].replace(',', '.')), k.mean ?? 0, k.name));
    assert.equal(JSON.parse((await save(all, 'JSON')).toString('utf8')).length, run.kpis.length);
    const chart = 'section:has-text("machine’s time") .with-save:has(.chart)';
    assert.deepEqual([...(await save(chart, 'PNG')).subarray(1, 4)].map((c) => String.fromCharCode(c)).join(''), 'PNG');
    assert.match((await save(chart, 'SVG')).toString('utf8'), /^<svg[\s\S]*cutting/);
  });

  // Real answers of every kind of study, with small budgets.
  const regime = [
    { name: 'gamma', pointer: '/tools/0/strategy/gamma', unit: '1', low: 0.3, high: 0.9 },
    { name: 'speed', pointer: '/operations/0/process/cutting_speed_m_min', unit: 'm/min', low: 40, high: 80 },
  ];
  const cost = { kpi: 'cost_per_part', direction: 'minimize' };
  const studied = (name, more, ...flags) => {
    const file = join(folder, `${name}.json`);
    writeFileSync(file, JSON.stringify({ name, scenario: resolve(options.scenarios, 'heavy-lathe.json'), variables: regime, confirmation: { replications: 5 }, ...more }));
    return JSON.parse(verstat('optimize', file, '--json', '--progress', 'none', ...flags)).study;
  };
  const cells = (where) => page.locator(`${where} tbody tr`).evaluateAll((all) => all.map((r) => [...r.cells].map((c) => c.textContent)));
  const short = (x, digits) => Number(x.toPrecision(digits));
  /** Rows of a table of shares: each adds up to 100.0 %, as its last cell says. */
  const hundred = (rows, count) => {
    assert.equal(rows.length, count);
    for (const r of rows) {
      assert.equal(r.at(-1), '100.0');
      const numbers = r.slice(1, -1).filter((x) => x.includes('.')).map((x) => Math.round(10 * Number(x)));
      assert.equal(numbers.reduce((a, b) => a + b, 0), 1000, String(r));
    }
  };

  await journey('a study shows what holds its plan back, one cut against the shop, and what uncertain inputs do', async () => {
    const id = studied('Bound by throughput', { objective: cost, constraints: [{ kpi: 'throughput_per_h', at_least: 3.4 }], search: { max_evaluations: 300, starts: 1 }, uncertain: [{ name: 'Taylor exponent', pointer: '/inserts/0/edge_life/speed_exponent', relative: 0.1 }] });
    const { result } = json('--study', String(id));
    assert.ok(result.binding.length > 0 && result.one_cut.length > 0 && result.sensitivity.length > 0);
    await open(`#/studies/${id}`);
    const [bound] = await cells('section:has(> h2:has-text("What holds the plan back"))');
    assert.equal(Number(plain(bound[2])), short(result.binding[0].allowed, 6));
    assert.equal(Number(plain(bound[4])), short(result.binding[0].shadow_price, 3));
    const [cut] = await cells('section:has(> h2:has-text("One cut against the shop"))');
    const one = result.one_cut[0];
    assert.deepEqual(cut.slice(0, 4), [one.operation, ...[one.speed_min_cost_m_min, one.speed_max_rate_m_min, one.speed_shop_m_min].map((v) => String(short(v, 4)))]);
    const [moved] = await cells('section:has(> h2:has-text("What uncertain inputs do"))');
    assert.equal(Number(plain(moved[1])), short(result.sensitivity[0].objective_low, 6));
    await page.waitForSelector('section:has(> h2:has-text("What uncertain inputs do")) .chart[data-drawn]');
    await accessible(page, 'bound study');
    await page.locator('section:has(> h2:has-text("What holds the plan back"))').scrollIntoViewIfNeeded();
  });

  await journey('a click on a point of the front shows its plan, which opens as a scenario', async () => {
    const id = studied('Cost and throughput', { objectives: [cost, { kpi: 'throughput_per_h', direction: 'maximize' }], front: { points: 5, replications: 3 }, search: { max_evaluations: 200, starts: 1 } });
    const { front } = json('--study', String(id)).result;
    await open(`#/studies/${id}`);
    const where = 'section:has(> h2:has-text("Several objectives"))';
    await page.waitForSelector(`${where} .chart[data-drawn]`);
    // Points have no elements of their own on a canvas: the cursor becomes a hand over one.
    const canvas = page.locator(`${where} canvas`).first();
    await canvas.scrollIntoViewIfNeeded();
    const over = await canvas.evaluate((c) => {
      const box = c.getBoundingClientRect();
      for (let y = 4; y < box.height; y += 4)
        for (let x = 60; x < box.width; x += 4) {
          c.dispatchEvent(new MouseEvent('mousemove', { clientX: box.x + x, clientY: box.y + y, bubbles: true }));
          if (c.parentElement.style.cursor === 'pointer') return { x: box.x + x, y: box.y + y };
        }
      return null;
    });
    assert.ok(over, 'no point of the front is under any pixel');
    await page.mouse.click(over.x, over.y);
    const hit = (await page.locator('#front-plan[data-point]').count()) > 0;
    assert.ok(hit, 'no point of the front could be clicked');
    await page.click(`${where} button[aria-label="Show the plan of point 2"]`);
    assert.equal(await page.getAttribute('#front-plan', 'data-point'), '1');
    const plan = (await cells('#front-plan')).map((r) => Number(plain(r[2])));
    assert.deepEqual(plan, front.points[1].values.map((v) => short(v.value, 6)));
    await accessible(page, 'front');
    await picture('front', where);
    await page.click('#front-plan button:text-is("Open this plan as a scenario")');
    await page.waitForSelector('#check.good');
    const scenario = JSON.parse(await page.inputValue('#scenario-text'));
    assert.equal(scenario.tools[0].strategy.gamma, front.points[1].values[0].value);
  });

  await journey('an interrupted study goes on from its page to the same answer', async () => {
    const more = { objective: cost, search: { max_evaluations: 80, starts: 1 } };
    const whole = json('--study', String(studied('In one go', more))).result;
    const id = studied('Stopped early', more, '--time', '0.001');
    assert.equal(json('--study', String(id)).status, 'interrupted');
    await open(`#/studies/${id}`);
    await page.click('#resume');
    await page.waitForSelector('#resume', { state: 'detached' });
    await page.waitForSelector('.finding.better');
    const study = json('--study', String(id));
    assert.equal(study.status, 'finished');
    assert.deepEqual(study.result.best, whole.best);
  });

  await journey('a large shop shows its bottleneck, lead time, losses in three groupings and its consumption', async () => {
    const { id } = JSON.parse(verstat('run', join(options.scenarios, 'pump-shop.json'), '--json', '--replications', '10'));
    const run = json('--run', String(id), '--all-replications');
    const mean = (name) => run.kpis.find((k) => k.name === name).mean;
    await open(`#/runs/${id}`);
    const longest = run.kpis.filter((k) => k.name.endsWith('/active_period_min')).sort((a, b) => b.mean - a.mean)[0].name.split('/')[1];
    assert.equal(await page.getAttribute('#bottleneck', 'data-machine'), longest);
    const phases = await cells('section:has(> h2:text-matches("^Lead time"))');
    assert.ok(Math.abs(phases.reduce((sum, r) => sum + Number(r[2]), 0) - 100) < 0.01);
    const phase = run.kpis.find((k) => k.name === 'lead_time/queue_min');
    assert.ok(phases.some((r) => r[1] === `${printedThousands(phase)}`), `${phases}`);
    const groups = await cells('section:has(> h2:has-text("SEMI E10"))');
    groups.forEach((r) => assert.ok(Math.abs(r.slice(1).reduce((sum, x) => sum + Number(x), 0) - 100) < 0.01, String(r)));
    const saw = groups.find((r) => r[0] === 'saw');
    assert.ok(Math.abs(Number(saw[5]) - 100 * mean('machine/saw/state/off_shift')) < 0.11);
    const six = await cells('section:has(> h2:has-text("Six big losses"))');
    assert.ok(six.length > 0);
    await page.waitForSelector('#consumption table');
    const [used] = await cells('#consumption');
    const insert = run.kpis.find((k) => k.name === `insert/${used[0]}/consumption`);
    assert.equal(Number(plain(used[2])), [...insert.values].sort((a, b) => a - b)[8]);
    await page.waitForSelector('section:has(> h2:has-text("Parts, scrap and rework")) .chart[data-drawn]');
    assert.match(await page.getAttribute('section:has(> h2:has-text("Parts, scrap and rework")) .chart', 'aria-label'), /to rework/);
    await accessible(page, 'pump shop');
    await picture('shop', 'section:has(> h2:has-text("Bottleneck"))');
    await picture('sankey', 'section:has(> h2:has-text("Parts, scrap and rework"))');
  });

  await journey('a run is divided by shift and by hour; crews stand in its Gantt chart with what they do', async () => {
    const { id } = JSON.parse(verstat('run', join(options.scenarios, 'pump-shop.json'), '--json', '--replications', '2'));
    const trace = JSON.parse(execFileSync(options.program, ['trace', join(options.scenarios, 'pump-shop.json')], { encoding: 'utf8', maxBuffer: 1 << 28 }));
    await open(`#/runs/${id}`);
    await page.click('#record-slices');
    await page.waitForSelector('#shifts-table');
    const named = await page.inputValue('#shifts-row');
    const machine = trace.machines.filter((m) => m.calendar !== null)[Number(named)];
    // 06:00 to 22:00 on working days, minute by minute from the intervals of the command line.
    const shift = trace.shifts[machine.calendar][0];
    const on = (x) => shift.days.includes(Math.floor(x / 1440) % 7) && (x % 1440) / 60 >= shift.from_h && (x % 1440) / 60 < shift.to_h;
    const minutes = {};
    let all = 0;
    for (const [from, to, state] of machine.intervals) {
      // Shifts begin on whole half hours: between two of them nothing changes.
      for (let a = Math.max(from, trace.warmup_min); a < to; ) {
        const b = Math.min(to, (Math.floor(a / 30) + 1) * 30);
        if (on(a)) {
          minutes[state] = (minutes[state] ?? 0) + b - a;
          all += b - a;
        }
        a = b;
      }
    }
    const rows = await cells('#shifts-table');
    hundred(rows, 2);
    assert.match(rows[0][0], /Mon–Fri 06:00–22:00/);
    assert.equal(rows[1][0], 'outside the shifts');
    const head = await page.locator('#shifts-table thead th').allTextContents();
    const cutting = rows[0][head.findIndex((x) => x.startsWith('other operations') || x.startsWith('cutting'))];
    assert.ok(Math.abs(Number(cutting) - (100 * (minutes.cutting ?? minutes.working)) / all) <= 0.1001, `${rows[0]} against ${JSON.stringify(minutes)} of ${all}`);
    hundred(await cells('#hours-table'), 24);
    await page.waitForSelector('#slices .chart[data-drawn]');
    await picture('shifts', '#slices section');
    await page.selectOption('#shifts-row', { label: 'inspector' });
    hundred(await cells('#shifts-table'), 2);
    await accessible(page, 'slices');
    await open(`#/trace/${id}`);
    await page.click('#record');
    await page.waitForSelector('canvas[data-bars]');
    const shares = await cells('section:has(> h2:has-text("Shares of the time shown"))');
    assert.deepEqual(shares.map((r) => r[0]), [...trace.machines, ...trace.crews].map((r) => r.name));
    // The mouse over a crew says what is done and where.
    const place = trace.machines.length + trace.crews.findIndex((c) => c.name === 'setter');
    const canvas = page.locator('canvas.gantt');
    await canvas.scrollIntoViewIfNeeded();
    const said = await canvas.evaluate((c, r) => {
      const box = c.getBoundingClientRect();
      const found = new Set();
      for (let x = 151; x < box.width; ++x) {
        c.dispatchEvent(new MouseEvent('mousemove', { clientX: box.x + x, clientY: box.y + r * 22 + 11, bubbles: true }));
        found.add(document.getElementById('trace-under').textContent.split(', ').slice(0, 1)[0]);
        if (/set-up \(/.test(document.getElementById('trace-under').textContent)) return document.getElementById('trace-under').textContent;
      }
      return [...found].join();
    }, place);
    assert.match(said, /^setter, .*: set-up \(.+\), /);
    await picture('gantt', 'section:has(canvas.gantt)');
    // Saved whole, it opens again as it was.
    const drawn = await page.getAttribute('canvas', 'data-bars');
    await page.click('section:has(canvas.gantt) summary:text-is("Save")');
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('section:has(canvas.gantt) .save-items button:text-is("JSON of the replication, to open here again")')]);
    const file = join(folder, 'saved.json');
    writeFileSync(file, readFileSync(await download.path()));
    await open('#/trace');
    await page.setInputFiles('#trace-file', file);
    await page.waitForSelector('canvas[data-bars]');
    assert.equal(await page.getAttribute('canvas', 'data-bars'), drawn);
  });

  await journey('edges of a replication are exported for Excel, fitted, and give back the life they were made with', async () => {
    const { id } = JSON.parse(verstat('run', join(options.scenarios, 'heavy-lathe.json'), '--json', '--set', '/simulation/horizon_min=40000', '--replications', '1'));
    await open(`#/trace/${id}`);
    await page.click('#record');
    await page.waitForSelector('canvas[data-bars]');
    await page.click('section:has(canvas.gantt) summary:text-is("Save")');
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('section:has(canvas.gantt) .save-items button:text-is("Log of edges for Excel (; and decimal comma)")')]);
    const text = readFileSync(await download.path(), 'utf8');
    assert.match(text, /^\uFEFFtool;machine;at_min;cutting time \[min\];cause\r\n/);
    assert.match(text, /;\d+,\d+;(planned|failed)\r\n/);
    const file = join(folder, 'edges.csv');
    writeFileSync(file, text);
    await open('#/fit');
    await page.setInputFiles('#fit-file', file);
    await page.waitForSelector('#fit-file-facts:has-text("cutting time")');
    await page.fill('[data-flag=tool]', 'roughing tool');
    await page.click('#fit-start');
    await page.waitForSelector('.job[data-state=finished]', { timeout: 60_000 });
    await page.waitForSelector('#fit-answer .chart[data-drawn]');
    const [law] = await cells('#fit-answer section:has(> h2:has-text("roughing tool"))');
    assert.equal(law[0], 'weibull');
    // 60 min and CV 0.7 (T5K10 of the gallery) from some 1,900 edges, most of them taken out before they failed.
    assert.ok(Math.abs(Number(law[1]) - 60) < 8, String(law));
    assert.ok(Math.abs(Number(law[2]) - 0.7) < 0.08, String(law));
  });

  await journey('orders are read into a scenario from a spreadsheet’s CSV, saved, and read again', async () => {
    await open('#/scenario/gallery/heavy-lathe');
    await page.waitForSelector('#check.good');
    const scenario = JSON.parse(await page.inputValue('#scenario-text'));
    scenario.simulation.warmup_min = 0;
    scenario.parts[0].supply = { kind: 'orders', orders: [{ arrives_min: 0, quantity: 1 }] };
    await page.fill('#scenario-text', JSON.stringify(scenario));
    await page.waitForSelector('#check.good');
    for (const pointer of ['/parts', '/parts/0', '/parts/0/supply', '/parts/0/supply/orders']) await page.click(`.group[data-pointer="${pointer}"] > summary`);
    const input = '.group[data-pointer="/parts/0/supply/orders"] input.csv-list';
    const file = join(folder, 'orders.csv');
    const orders = async () => JSON.parse(await page.inputValue('#scenario-text')).parts[0].supply.orders;
    writeFileSync(file, '\uFEFFArrives [min];Quantity;Due [min]\r\n12,5;3;5000\r\n480;1;\r\n1 440,25;20;9000,5\r\n');
    await page.setInputFiles(input, file);
    const wanted = [{ arrives_min: 12.5, quantity: 3, due_min: 5000 }, { arrives_min: 480, quantity: 1 }, { arrives_min: 1440.25, quantity: 20, due_min: 9000.5 }];
    await page.waitForFunction(() => JSON.parse(document.getElementById('scenario-text').value).parts[0].supply.orders.length === 3);
    assert.deepEqual(await orders(), wanted);
    await page.waitForSelector('#check.good');
    const list = '.group[data-pointer="/parts/0/supply/orders"]';
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`${list} > .group-body > p button:text-is("CSV for Excel (; and decimal comma)")`)]);
    const saved = readFileSync(await download.path(), 'utf8');
    assert.match(saved, /12,5;3;5000/);
    writeFileSync(file, 'arrives_min;quantity\n1;2\n3\n');
    await page.setInputFiles(input, file);
    await page.waitForSelector(`${list} .bad:has-text("Line 3 has 1 cells, the header 2")`);
    assert.deepEqual(await orders(), wanted);
    writeFileSync(file, saved);
    await page.setInputFiles(input, file);
    await page.waitForSelector(`${list} .bad:has-text("Line 3")`, { state: 'detached' });
    assert.deepEqual(await orders(), wanted);
    await page.click('#start-run');
    await page.waitForSelector('.job[data-state=finished]', { timeout: 60_000 });
    const id = /runs\/(\d+)/.exec(await page.getAttribute('#results thead a[href^="#/runs/"]', 'href'))[1];
    const made = (name) => json('--run', id).kpis.find((k) => k.name === name).mean;
    assert.equal(Math.round(1e6 * (made('parts_good') + made('parts_scrapped'))) / 1e6, 24);
  });

  await journey('every step of a scenario’s history can be gone back to', async () => {
    await open('#/scenario/gallery/heavy-lathe');
    await page.waitForSelector('#check.good');
    await page.click('.shop-graph .node.machine');
    const count = '[data-pointer="/machines/0/count"] input[type=text]';
    for (const n of ['3', '4', '5']) {
      await page.fill(count, n);
      await page.press(count, 'Tab');
      await page.waitForSelector(`#history td:nth-of-type(2) code:text-is("${n}")`);
    }
    await page.click('#history details:has(.steps) > summary');
    assert.equal(await page.locator('#history .steps li').count(), 4);
    await page.click('#history .steps li:nth-child(2) button');
    await page.waitForSelector('#history td:nth-of-type(2) code:text-is("3")');
    assert.equal(JSON.parse(await page.inputValue('#scenario-text')).machines[0].count, 3);
    await page.click('button:text-is("Redo")');
    await page.waitForSelector('#history td:nth-of-type(2) code:text-is("4")');
    // Left and opened again, it is as it was.
    await open('#/models');
    await open('#/scenario');
    await page.waitForSelector('#history td:nth-of-type(2) code:text-is("4")');
  });

  await journey('a shop that locks itself is warned of above its figures', async () => {
    const machine = (name) => ({ name, queue_capacity: 0 });
    const operation = (name, on) => ({ name, machine: on, process: { kind: 'duration', time: { kind: 'exponential', rate_per_min: 0.5 } } });
    const part = (name, route) => ({ name, route, store: 'out', supply: { kind: 'interarrival', time: { kind: 'exponential', rate_per_min: 0.1 } } });
    const file = join(folder, 'crossing.json');
    writeFileSync(file, JSON.stringify(CROSSING(machine, operation, part)));
    const { id } = JSON.parse(verstat('run', file, '--json'));
    const share = json('--run', String(id)).kpis.find((k) => k.name === 'standstill_share');
    assert.ok(share.mean > 0.5);
    await open(`#/runs/${id}`);
    assert.ok((await page.textContent('#standstill')).includes(`${printed(share, 100).mean} ${printed(share, 100).half} %`), await page.textContent('#standstill'));
    await accessible(page, 'standstill');
    await open('#/runs/1');
    assert.equal(await page.locator('#standstill').count(), 0);
  });

  await journey('a study whose program is killed turns "interrupted" under one’s eyes and goes on from its page', async () => {
    const more = { objective: cost, search: { max_evaluations: 400, starts: 1 }, confirmation: { replications: 150 } };
    const whole = json('--study', String(studied('Not killed', more))).result;
    const study = join(folder, 'killed.json');
    writeFileSync(study, JSON.stringify({ name: 'Killed', scenario: resolve(options.scenarios, 'heavy-lathe.json'), variables: regime, ...more }));
    const child = spawn(options.program, ['optimize', study, '--json', '--progress', 'json', '--db', db], { stdio: ['ignore', 'ignore', 'pipe'] });
    const id = await new Promise((done, fail) => {
      let said = '';
      child.stderr.on('data', (data) => {
        said += data;
        const line = said.split('\n').find((x) => x.startsWith('{'));
        if (line && said.includes('\n')) done(JSON.parse(line).study);
      });
      child.on('exit', (code) => fail(new Error(`ended with ${code} before it could be killed: ${said}`)));
    });
    child.removeAllListeners('exit');
    child.kill('SIGSTOP'); // as slow as it takes
    await open(`#/studies/${id}`);
    await page.waitForSelector('#live');
    const gone = ended(child);
    child.kill('SIGKILL');
    await gone;
    await page.waitForSelector('#resume');
    assert.equal(json('--study', String(id)).status, 'interrupted');
    await open('');
    assert.match(await page.textContent(`section:has(h2:has-text("Studies")) tbody tr:has(a[href="#/studies/${id}"])`), /interrupted/);
    await open(`#/studies/${id}`);
    await accessible(page, 'killed study');
    await page.click('#resume');
    await page.waitForSelector('#resume', { state: 'detached', timeout: 60_000 });
    await page.waitForSelector('.finding');
    assert.deepEqual(json('--study', String(id)).result.best, whole.best);
  });

  await journey('the losses of a run are priced as verstat losses does', async () => {
    const { id } = JSON.parse(verstat('run', join(options.scenarios, 'tools-unattended.json'), '--json', '--replications', '4'));
    const direct = JSON.parse(execFileSync(options.program, ['losses', join(options.scenarios, 'tools-unattended.json'), '--replications', '4', '--json', '--progress', 'none', '--db', join(folder, 'losses.db')], { encoding: 'utf8' }));
    const share = json('--run', String(id)).kpis.find((k) => k.name.endsWith('/no_stop_share'));
    await open(`#/runs/${id}`);
    const [tool] = await cells('section:has(> h2:has-text("An unattended interval"))');
    assert.equal(tool[1], `${printed(share, 100).mean} ${printed(share, 100).half}`);
    const of = (name) => json('--run', String(id)).kpis.find((k) => k.name === `tool/${tool[0]}/${name}`);
    assert.equal(tool[2], ['low', 'high'].map((end) => String(short(100 * of(`unattended/no_stop_${end}`).mean, 4))).join(' … '));
    assert.equal(tool[4], String(short(of('sisters_needed_surely').mean, 6)));
    await page.waitForSelector('#consumption table');
    const kpis = json('--run', String(id)).kpis;
    for (const row of await cells('#consumption')) {
      const path = row[0].startsWith('grade ') ? `grade/${row[0].slice(6)}` : `insert/${row[0]}`;
      const of_ = (leaf) => kpis.find((k) => k.name === `${path}/${leaf}`);
      const said = (kpi) => { const p = printed(kpi); return `${p.mean} ${p.half}`; };
      assert.equal(plain(row[3]), said(of_('consumption_per_week')));
      assert.equal(plain(row[4]), said(of_('consumption_week_p90')));
    }
    const onMachines = await cells('section:has(> h2:has-text("Insert-cycle availability"))');
    assert.ok(onMachines.length > 1);
    for (const [name, machine, value] of onMachines) { const p = printed(kpis.find((k) => k.name === `tool/${name}/on/${machine}/insert_cycle_availability`), 100); assert.equal(value, `${p.mean} ${p.half}`); }
    await page.click('#price-losses');
    await page.waitForSelector('#losses .losses table');
    const rows = await cells('#losses .losses');
    assert.equal(rows.length, direct.losses.length);
    for (const loss of direct.losses) {
      const row = rows.find((r) => r[0] === loss.name);
      const week = 10080 / direct.minutes;
      assert.ok(Math.abs(Number(plain(row[1].split(' ± ')[0])) - loss.parts.mean * week) <= Math.max(0.01, 0.1 * loss.parts.half_width * week), `${row} against ${loss.parts.mean * week}`);
    }
    await page.waitForSelector('#losses .chart[data-drawn]');
    await accessible(page, 'losses');
    await picture('losses', 'section:has(#losses)');
  });

  await journey('a table of the shop is fitted as verstat fit does, and its laws go into a scenario', async () => {
    const file = resolve(options.scenarios, '../../docs/examples/fit/removals.csv');
    const direct = JSON.parse(execFileSync(options.program, ['fit', 'life', file, '--tool', 'T5K10', '--to', '/inserts/0', '--json'], { encoding: 'utf8' }));
    await open('#/fit');
    await page.setInputFiles('#fit-file', file);
    await page.waitForSelector('#fit-file-facts:has-text("Cutting time, min")');
    await page.fill('[data-flag=tool]', 'T5K10');
    await page.fill('[data-flag=tool]', 'nothing');
    await page.click('#fit-start');
    await page.waitForSelector('.job[data-state=failed] .bad:has-text("no row of 87 can be used")');
    await page.fill('[data-flag=tool]', 'T5K10');
    await page.fill('[data-flag=to]', '/inserts/0');
    await page.click('#fit-start');
    await page.waitForSelector('.job[data-state=finished]');
    await page.waitForSelector('#fit-answer .chart[data-drawn]');
    const laws = await cells('#fit-answer section:has(> h2:has-text("T5K10"))');
    direct.groups[0].laws.forEach((law, k) => assert.deepEqual(laws[k].slice(0, 2).map((x, n) => (n === 0 ? x : Number(plain(x)))), [law.family, short(law.life_mean, 4)]));
    await accessible(page, 'fit');
    await picture('fit', '#fit-answer section:has(> h2:has-text("T5K10"))');
    await page.selectOption('#fit-scenario', 'heavy-lathe');
    await page.click('#fit-use');
    await page.waitForSelector('#check.good');
    const scenario = JSON.parse(await page.inputValue('#scenario-text'));
    const cv = direct.patch.changes.find((c) => c.pointer === '/inserts/0/edge_life/cv');
    assert.equal(scenario.inserts[0].edge_life.cv, cv.value);
  });

  await journey('wear, stops, orders and cycle times go through the same page; an order list becomes orders', async () => {
    await open('#/fit');
    const ask = async (what, name, flags) => {
      await page.selectOption('#fit-what', what);
      await page.setInputFiles('#fit-file', resolve(options.scenarios, `../../docs/examples/fit/${name}`));
      await page.waitForSelector(`#fit-file-facts:has-text("${name}")`);
      for (const [flag, value] of Object.entries(flags)) {
        const field = page.locator(`[data-flag=${flag}]`);
        if (await field.evaluate((e) => e.tagName) === 'SELECT') await field.selectOption(value);
        else await field.fill(value);
      }
      await page.click('#fit-start');
      await page.waitForSelector('#fit-answer section');
    };
    await ask('taylor', 'wear.csv', { at: '150,0.2,1' });
    await page.waitForSelector('#fit-answer [data-entry^=insert]');
    await ask('downtime', 'downtime.csv', {});
    await page.waitForSelector('#fit-answer [data-entry=failure-spindle]');
    await ask('cycle', 'cycles.csv', { operation: 'deburring', to: '/operations/0/process/time' });
    await page.waitForSelector('#fit-answer td:has-text("empirical")');
    await ask('arrivals', 'orders.csv', { as: 'orders', to: '/parts/0/supply' });
    await page.selectOption('#fit-scenario', 'heavy-lathe');
    await page.click('#fit-use');
    await page.waitForSelector('#check.good');
    const scenario = JSON.parse(await page.inputValue('#scenario-text'));
    assert.equal(scenario.parts[0].supply.kind, 'orders');
    assert.equal(scenario.parts[0].supply.orders.length, 182);
  });

  await journey('the tool-change sheet and the morning report print', async () => {
    await open('#/sheet/1');
    const plan = JSON.parse(execFileSync(options.program, ['models', 'eval', 'K117.gamma_percent_life', '--inputs', '{"gamma": 0.64}'], { encoding: 'utf8' }));
    const cells = await page.locator('tbody tr').first().locator('th, td').allTextContents();
    const [, , merged, , age, cutting] = cells;
    assert.equal(Number(age), Number(plan.T_gamma_min.toPrecision(4)));
    assert.equal(Number(merged), Math.floor(plan.T_gamma_min / Number(plain(cutting))));
    await charts(1);
    await page.emulateMedia({ media: 'print' });
    assert.equal(await page.locator('#top nav').isVisible(), false);
    assert.ok((await page.pdf({ format: 'A4' })).length > 10_000);
    await page.emulateMedia({ media: 'screen' });
    await accessible(page, 'sheet');
    await open('#/report/1');
    const study = json('--study', '1');
    assert.equal(await page.textContent('#finding'), study.result.words.replaceAll('+-', '±'));
    const changes = await page.locator('section:has-text("What to change") tbody tr').allTextContents();
    assert.equal(changes.length, study.variables.length);
    await accessible(page, 'report');
    await picture('report');
  });

  await journey('the Gantt chart of a large run opens and zooms from a year to a minute', async () => {
    await open('#/trace/1');
    await page.click('#record');
    await page.waitForSelector('canvas[data-bars]');
    const trace = JSON.parse(execFileSync(options.program, ['trace', join(options.scenarios, 'heavy-lathe.json')], { encoding: 'utf8', maxBuffer: 1 << 28 }));
    // The shares of the whole horizon are those of the trace that the command line writes.
    const cutting = trace.machines[0].intervals.filter((i) => i[2] === 'cutting').reduce((sum, [a, b]) => sum + b - a, 0);
    const column = (await page.locator('section:has-text("Shares of the time shown") thead th').allTextContents()).findIndex((x) => x.startsWith('cutting'));
    const first = await page.locator('section:has-text("Shares of the time shown") tbody tr').first().locator('th, td').allTextContents();
    assert.equal(first[0], trace.machines[0].name);
    assert.equal(first[column], ((100 * cutting) / trace.horizon_min).toFixed(1));
    // Crews and the edges of the tools stand in rows of their own, parts in the shop over time below.
    const tools = new Set(trace.edges.map(([tool, machine]) => `${machine}: ${tool}`));
    assert.match(await page.getAttribute('canvas.gantt', 'aria-label'), new RegExp(`of ${trace.machines.length + trace.crews.length + tools.size} rows`));
    const setter = trace.crews[0];
    const changing = setter.intervals.filter((i) => i[2] === 'planned_change').reduce((sum, [a, b]) => sum + b - a, 0);
    const of = (await page.locator('section:has-text("Shares of the time shown") thead th').allTextContents()).findIndex((x) => x.startsWith('planned change'));
    const row = (await cells('section:has(> h2:has-text("Shares of the time shown"))')).find((r) => r[0] === setter.name);
    assert.equal(row[of], ((100 * changing) / trace.horizon_min).toFixed(1));
    await page.waitForSelector('section:has(> h2:has-text("Parts in the shop over time")) .chart[data-drawn]');
    hundred(await cells('#hours-table'), 24);
    await page.uncheck('#trace-tool');
    await page.waitForFunction((n) => document.querySelector('canvas.gantt').getAttribute('aria-label').includes(`of ${n} rows`), trace.machines.length + trace.crews.length);
    await page.fill('#trace-filter', 'nothing of the kind');
    await page.waitForSelector('#trace-left:has-text("No row is chosen")');
    await page.fill('#trace-filter', '');
    await page.check('#trace-tool');
    // A year of sixty machines: 2.4 million intervals of 13 minutes.
    const length = 40_000;
    const until = Array.from({ length }, (_, k) => 13 * (k + 1));
    const machines = Array.from({ length: 60 }, (_, m) => ({ name: `machine ${m + 1}`, until, state: until.map((_, k) => (k + m) % 3) }));
    const file = join(folder, 'trace.json');
    writeFileSync(file, JSON.stringify({ states: ['cutting', 'idle', 'planned_change'], machines }));
    await open('#/trace');
    const opened = Date.now();
    await page.setInputFiles('#trace-file', file);
    await page.waitForSelector('canvas[data-bars]');
    const drawn = Number(await page.getAttribute('canvas', 'data-bars'));
    assert.ok(drawn > 60 && drawn <= 3 * 60 * 1480, `${drawn} bars`);
    const openMs = Date.now() - opened;
    // The wheel, from the year down to a minute: what each picture took to draw.
    const zooms = await page.evaluate(async () => {
      const canvas = document.querySelector('canvas.gantt');
      const times = [Number(canvas.dataset.ms)];
      while (Number(canvas.dataset.to) - Number(canvas.dataset.from) > 1.0001 && times.length < 80) {
        canvas.dispatchEvent(new WheelEvent('wheel', { deltaY: -100, bubbles: true, cancelable: true }));
        const before = canvas.dataset.from + canvas.dataset.to;
        while (canvas.dataset.from + canvas.dataset.to === before) await new Promise((done) => requestAnimationFrame(done));
        times.push(Number(canvas.dataset.ms));
      }
      return times;
    });
    console.log(`      a year of 60 machines: opened in ${openMs} ms; ${zooms.length} pictures from a year to a minute, the slowest ${Math.max(...zooms)} ms, the median ${zooms.sort((x, y) => x - y)[zooms.length >> 1]} ms`);
    assert.ok(zooms.length < 80, 'a minute was not reached');
    assert.ok(Math.max(...zooms) < 1000, 'zooming takes too long');
    await page.waitForFunction(() => Number(document.querySelector('canvas')?.dataset.bars) <= 120);
    await page.focus('canvas');
    await page.keyboard.press('Home');
    await page.waitForFunction((n) => Number(document.querySelector('canvas')?.dataset.bars) === n, drawn);
    await page.waitForFunction(() => {
      const cells = [...document.querySelectorAll('section:has(> h2:not(:empty)) tbody tr:first-child')].map((r) => [...r.cells].map((c) => c.textContent)).find((r) => r[0] === 'machine 1');
      return cells && cells.length === 4 && Math.abs(cells.slice(1).reduce((sum, x) => sum + Number(x), 0) - 100) < 0.2;
    });
    // More intervals than a spreadsheet takes are refused in words, a part of them is saved.
    const save = async (item) => {
      await page.click('section:has(canvas.gantt) summary:text-is("Save")');
      await page.click(`section:has(canvas.gantt) .save-items button:text-is("${item}")`);
    };
    await save('CSV of what is shown');
    await page.waitForSelector('.bad:has-text("no spreadsheet takes")');
    await page.click('button:text-is("One minute")');
    await page.waitForFunction(() => Number(document.querySelector('canvas')?.dataset.bars) <= 120);
    const [download] = await Promise.all([page.waitForEvent('download'), save('CSV of what is shown')]);
    const lines = readFileSync(await download.path(), 'utf8').trim().split('\r\n');
    assert.equal(lines[0], 'kind,name,state,from_min,to_min,machine');
    assert.ok(lines.length >= 61 && lines.length <= 121, `${lines.length} lines`);
    await accessible(page, 'trace');
    writeFileSync(file, '{"machines": [{"name": "x"}]}');
    await page.setInputFiles('#trace-file', file);
    await page.waitForSelector('.bad:has-text("/machines/0: needs")');
  });

  await journey('a function of the catalogue is drawn as a curve and as a map', async () => {
    await open('#/models/K117.weibull_from_moments');
    await page.click('#map-draw');
    await page.waitForSelector('#model-map .chart[data-drawn]');
    await page.selectOption('#map-y', 'cv');
    await page.waitForFunction(() => document.querySelector('#model-map .chart.tall[data-drawn]'));
    await accessible(page, 'map');
    await picture('map');
  });

  await journey('a model is found, evaluated with a decimal comma, and refuses a bad input beside its field', async () => {
    await open('#/models');
    await page.fill('#model-search', 'weibull moments');
    await accessible(page, 'models');
    await page.click('a:has-text("K117.weibull_from_moments")');
    await page.fill('#in-mean_min', '60');
    await page.fill('#in-cv', '0,7');
    await page.click('button[type=submit]');
    await page.waitForSelector('#model-note:has-text("Computed")');
    const shown = Number(await page.textContent('output[data-output=shape]'));
    const direct = JSON.parse(execFileSync(options.program, ['models', 'eval', 'K117.weibull_from_moments', '--inputs', '{"mean_min": 60, "cv": 0.7}'], { encoding: 'utf8' }));
    assert.equal(shown, Number(direct.shape.toPrecision(8)));
    await page.fill('#in-cv', '-1');
    await page.press('#in-cv', 'Enter');
    await page.waitForSelector('#error-cv:has-text("allowed 0.05 <= cv")');
    assert.equal(await page.getAttribute('#in-cv', 'aria-invalid'), 'true');
    await page.fill('#in-cv', 'much');
    await page.press('#in-cv', 'Enter');
    await page.waitForSelector('#error-cv:has-text("no number")');
    await accessible(page, 'model');
  });
  // The refused evaluations, plans and checks above are reported by the browser as failed requests; nothing else may be.
  const unexpected = complaints.splice(0).filter((c) => !/status of 422/.test(c));

  await journey('Ukrainian is a full language of the pages', async () => {
    await open('#/runs/1');
    await page.selectOption('#top select', 'uk');
    await page.waitForSelector('dt:has-text("Вартість деталі")');
    assert.match(await page.textContent('#tile-cost .value'), /^\d+,\d+$/);
    assert.equal(await page.getAttribute('html', 'lang'), 'uk');
    await page.selectOption('#top select', 'en');
    await page.waitForSelector('dt:has-text("Cost per part")');
  });

  await journey('dark colours and a narrow window keep everything readable', async () => {
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.setViewportSize({ width: 768, height: 1024 });
    await open('#/runs/1');
    await charts(2);
    await accessible(page, 'dark run');
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'the page scrolls sideways');
    await open('#/studies/1');
    await charts(2);
    await accessible(page, 'dark study');
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'the page scrolls sideways');
    for (const [hash, ready] of [['', '#run-search'], ['#/scenario/gallery/pump-shop', '#check.good'], ['#/operations/turning', '#plan-time'], ['#/models', '#model-search'], ['#/models/K117.weibull_from_moments', '#in-cv'], ['#/trace', '#trace-file'], ['#/fit', '#fit-file'], ['#/compare/1/2', 'tbody tr'], ['#/report/1', '#finding'], ['#/sheet/1', 'tbody tr']])
      for (const width of [768, 1280]) {
        await page.setViewportSize({ width, height: 1024 });
        await open(hash);
        await page.waitForSelector(ready);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${hash} scrolls sideways at ${width} px`);
        if (width === 768) await accessible(page, `dark ${hash}`);
      }
    await page.emulateMedia({ colorScheme: 'light' });
    await page.setViewportSize({ width: 1280, height: 800 });
  });

  await journey('loading, failed and too large say what is the matter and what to do', async () => {
    // A server that takes its time.
    await open('#/models');
    await page.route('**/api/v1/runs/1?*', async (route) => { await new Promise((done) => setTimeout(done, 700)); await route.continue(); }, { times: 1 });
    await page.evaluate(() => { location.hash = '#/runs/1'; });
    await page.waitForSelector('main .state:has-text("Loading")');
    assert.equal(await page.getAttribute('main', 'aria-busy'), 'true');
    await page.waitForSelector('#tile-cost');
    // One that fails once.
    await page.route('**/api/v1/runs/2?*', (route) => route.fulfill({ status: 503, contentType: 'application/json', body: '{"error": {"status": 503, "message": "the database is busy; try again"}}' }));
    await page.evaluate(() => { location.hash = '#/runs/2'; });
    await page.waitForSelector('[role=alert]:has-text("the database is busy; try again")');
    await accessible(page, 'failed');
    await page.unroute('**/api/v1/runs/2?*');
    await page.click('button:text-is("Try again")');
    await page.waitForSelector('#tile-cost');
    // Files that are no JSON, and too large for the server.
    await open('#/scenario');
    const file = join(folder, 'large.json');
    writeFileSync(file, '{"name": ');
    await page.setInputFiles('#scenario-file', file);
    await page.waitForSelector('.bad:has-text("large.json")');
    writeFileSync(file, `${readFileSync(join(options.scenarios, 'heavy-lathe.json'), 'utf8')}${' '.repeat(5 << 20)}`);
    await page.setInputFiles('#scenario-file', file);
    await page.waitForSelector('#check.bad:has-text("the server takes 4 MiB at once")');
    writeFileSync(file, `Cutting time, min;Cause\n${'45,0;planned\n'.repeat(200_000)}`);
    await open('#/fit');
    await page.setInputFiles('#fit-file', file);
    await page.waitForSelector('.bad:has-text("at most 2048 KiB")');
    complaints.splice(0).filter((c) => !/status of (503|413|422)/.test(c)).forEach((c) => unexpected.push(c));
  });

  await journey('a run that is not there says so and leads back', async () => {
    await open('#/runs/999');
    await page.waitForSelector('text=there is no run 999');
    await page.click('text=Back to runs and studies');
    await page.waitForSelector('#run-search');
    complaints.splice(0).filter((c) => !/status of 404/.test(c)).forEach((c) => unexpected.push(c));
  });

  await journey('nothing was asked of any other host and the browser had no complaints', async () => {
    assert.deepEqual(outside, []);
    assert.deepEqual([...unexpected, ...complaints], []);
  });

  await journey('a server that is ended says so on the page, and ends cleanly', async () => {
    await open('');
    const gone = ended(current.server);
    current.server.kill('SIGTERM');
    assert.equal(await gone, 0);
    await page.click('nav a:has-text("Models")');
    await page.waitForSelector('text=The server does not answer');
  });

  await journey('a new database says how to begin', async () => {
    const fresh = join(folder, 'fresh.db');
    const own = spawn(options.program, ['serve', '--db', fresh, '--port', '0'], { stdio: ['ignore', 'pipe', 'pipe'] });
    const url = await new Promise((done, fail) => {
      own.stdout.on('data', (data) => done(String(data).trim()));
      own.on('exit', (code) => fail(new Error(`ended with ${code}`)));
    });
    own.removeAllListeners('exit');
    await page.goto(url);
    await page.waitForSelector('main :has-text("verstat run")');
    await accessible(page, 'empty');
    const gone = ended(own);
    own.kill('SIGTERM');
    assert.equal(await gone, 0);
  });

  await journey('a read-only server starts nothing', async () => {
    current = await startServer('--read-only');
    const base = new URL(current.url).origin;
    const refused = await fetch(`${base}/api/v1/jobs`, { method: 'POST', headers: { 'X-Verstat': '1', 'Content-Type': 'application/json' }, body: '{"kind": "again", "run": 1}' });
    assert.equal(refused.status, 403);
    await page.goto(`${base}/#/scenario/gallery/heavy-lathe`);
    await page.waitForSelector('#start-run[disabled]');
    const gone = ended(current.server);
    current.server.kill('SIGTERM');
    assert.equal(await gone, 0);
  });

  await journey('with a token the pages ask for it, refuse a wrong one and open with the right one', async () => {
    const token = 'journeys-token-0123456789';
    current = await startServer('--token', token);
    const base = new URL(current.url).origin;
    assert.equal((await fetch(`${base}/api/v1/runs`)).status, 401);
    const stranger = await context.newPage();
    await stranger.goto(`${base}/`);
    await stranger.waitForSelector('text=This server asks for its token');
    await stranger.fill('#token', 'wrong');
    await stranger.click('button[type=submit]');
    await stranger.waitForSelector('text=The token was refused');
    await stranger.fill('#token', token);
    await stranger.click('button[type=submit]');
    await stranger.waitForSelector('#run-search');
    const guest = await context.newPage();
    await guest.goto(current.url);
    await guest.waitForSelector('#run-search');
    assert.ok(!guest.url().includes(token), 'the token stays in the address bar');
    const gone = ended(current.server);
    current.server.kill('SIGINT');
    assert.equal(await gone, 0);
    current = undefined;
  });
} catch (error) {
  failures += 1;
  console.log(`FAIL  setting up: ${error.stack ?? error}`);
} finally {
  await browser?.close();
  current?.server.kill('SIGKILL');
  rmSync(folder, { recursive: true, force: true });
}
console.log(failures === 0 ? 'all journeys passed' : `${failures} journeys failed`);
process.exit(failures === 0 ? 0 : 1);
