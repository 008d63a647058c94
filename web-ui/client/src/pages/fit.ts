// The shop's own data: a table of the shop becomes laws, and changes of a scenario that say where they come from.

import { api, ApiError, saveBlob } from '../api';
import { chart } from '../charts/chart';
import { weibullOption, type WeibullPoint } from '../charts/weibullPlot';
import { fragment, h, table, type Child } from '../dom';
import { significant, whole } from '../format';
import { gallery, galleryText } from '../gallery';
import { t, type Key } from '../i18n';
import { begin, changed, current, recall, remember } from '../logic/draft';
import { choices, decode, examples, forms, headers, mostBytes, type What } from '../logic/ownData';
import { applyChanges, type Json } from '../logic/pointer';
import { blocks, type Block } from '../logic/result';
import { title } from '../logic/schema';
import { section, type PageContext, type PageMaker } from '../page';
import type { Change } from '../types';
import { jobPanel } from '../ui/job';

interface Law {
  family: string;
  life_mean: number | null;
  life_cv: number | null;
  aicc: number | null;
  goodness_of_fit?: { p_value: number | null };
}
interface Interval {
  estimate?: number | null;
  low: number | null;
  high: number | null;
}
interface Group {
  tool?: string;
  regime?: string;
  edges: number;
  failures: number;
  not_fitted?: string;
  laws?: Law[];
  best?: { family: string; mean: Interval; gamma: number; gamma_percent_life: Interval };
  weibull_plot?: { points: WeibullPoint[]; line?: { shape: number; scale: number } };
}
interface Answer {
  table: { file: string; rows_in_file: number; rows_used: number; dropped: { line: number; reason: string }[]; notes: string[] };
  unit?: string;
  groups?: Group[];
  warnings?: string[];
  patch?: { changes: Change[]; provenance: Record<string, unknown> };
  library?: { kind: string; name: string; entry: unknown; provenance: { method: string; rows_used: number } }[];
  [more: string]: unknown;
}

/** A value of the scenario in a line: laws and lists as JSON, long ones cut. */
const brief = (value: unknown): string => {
  const text = typeof value === 'number' ? significant(value) : typeof value === 'object' && value !== null ? JSON.stringify(value) : String(value);
  return text.length > 160 ? `${text.slice(0, 160)}…` : text;
};
const number = (x: number | null | undefined, digits = 4) => (typeof x === 'number' ? significant(x, digits) : '–');
const bounds = (i: Interval) => `${number(i.estimate)} (${number(i.low)} … ${number(i.high)})`;

export const fitPage: PageMaker = async (context) => {
  const version = await api.version(context.signal);
  let text = '';
  let file = 'table.csv';
  const note = h('p', { class: 'bad', role: 'alert', id: 'fit-note' });
  const facts = h('p', { class: 'muted', role: 'status', id: 'fit-file-facts' });
  const jobs = h('div');
  const answer = h('div', { id: 'fit-answer' });
  const what = h('select', { id: 'fit-what', onchange: () => build() }, (Object.keys(forms) as What[]).map((w) => h('option', { value: w }, t(`fit.what.${w}`))));
  const columns = h('div', { class: 'row', id: 'fit-columns' });
  const options = h('div', { class: 'row', id: 'fit-options' });
  const start = h('button', { type: 'button', id: 'fit-start', disabled: true, onclick: () => run() }, t('fit.start'));
  const chosen = () => what.value as What;

  const build = () => {
    const form = forms[chosen()];
    const heads = headers(text);
    columns.replaceChildren(...[...form.needs, ...form.uses].map((role) => h('label', {}, role.replace('_', ' '), form.needs.includes(role) ? ' *' : '', ' ',
      h('select', { 'data-role': role }, h('option', { value: '' }, t('fit.byName')), heads.map((x) => h('option', { value: x }, x))))));
    options.replaceChildren(
      ...form.options.map((flag) => h('label', {}, h('code', {}, `--${flag}`), ' ',
        choices[flag]
          ? h('select', { 'data-flag': flag }, choices[flag].map((c) => h('option', { value: c }, c === '' ? t('fit.found') : c)))
          : h('input', { 'data-flag': flag, type: 'text', size: 12, placeholder: examples[chosen()][flag] }))),
      ...(form.switches ?? []).map((flag) => h('label', {}, h('input', { 'data-switch': flag, type: 'checkbox' }), ' ', h('code', {}, `--${flag}`))));
    start.disabled = version.read_only || text === '';
  };
  const load = (bytes: ArrayBuffer, name: string) => {
    note.textContent = '';
    if (bytes.byteLength > mostBytes) {
      note.textContent = t('fit.tooLarge', { file: name, size: whole(bytes.byteLength / 1024) });
      return;
    }
    const read = decode(bytes);
    text = read.text;
    file = name;
    const lines = text.split(/\r\n|\n|\r/).filter((l) => l.trim() !== '').length;
    facts.textContent = t('fit.read', { file: name, rows: whole(Math.max(0, lines - 1)), columns: headers(text).join(' | '), encoding: read.encoding });
    build();
  };
  const input = h('input', { id: 'fit-file', type: 'file', accept: '.csv,.txt,.tsv,text/csv', onchange: () => {
    const picked = input.files?.[0];
    if (picked) void picked.arrayBuffer().then((bytes) => { input.value = ''; load(bytes, picked.name); });
  } });
  const paste = h('textarea', { id: 'fit-text', rows: 5, spellcheck: 'false', onchange: () => { if (paste.value.trim() !== '') load(new TextEncoder().encode(paste.value).buffer as ArrayBuffer, 'table.csv'); } });

  const values = (place: HTMLElement, key: string): Record<string, string> =>
    Object.fromEntries([...place.querySelectorAll<HTMLInputElement | HTMLSelectElement>(`[data-${key}]`)].flatMap((e) => (e.value.trim() === '' ? [] : [[e.dataset[key] ?? '', e.value.trim()]])));
  const run = () => {
    note.textContent = '';
    start.disabled = true;
    const failed = (e: unknown) => { start.disabled = false; note.textContent = e instanceof ApiError && e.message ? e.message : e instanceof ApiError ? t('state.offline') : String(e); };
    const asked = { what: chosen(), table: text, file, columns: values(columns, 'role'), options: { ...values(options, 'flag'), ...Object.fromEntries([...options.querySelectorAll<HTMLInputElement>('[data-switch]:checked')].map((e) => [e.dataset.switch ?? '', true])) } };
    answer.replaceChildren();
    api.startJob({ kind: 'fit', fit: asked }).then(
      (job) => jobs.replaceChildren(jobPanel(context, job, (end) => {
        start.disabled = false;
        if (end.state !== 'finished') return;
        api.jobOutput(end.id, context.signal).then((json) => {
          const drawers: (() => void)[] = [];
          answer.replaceChildren(shown({ ...context, whenShown: (d) => drawers.push(d) }, json as Answer));
          drawers.forEach((d) => d());
        }, failed);
      })),
      failed,
    );
  };
  build();
  return {
    title: t('fit.title'),
    body: fragment(
      h('h1', {}, t('fit.title')),
      section(t('fit.table'), '',
        version.read_only ? h('p', { class: 'warn' }, t('state.readOnly')) : null,
        h('p', { class: 'row' }, h('label', { for: 'fit-what' }, t('fit.is')), what, h('label', { for: 'fit-file' }, t('fit.file')), input),
        h('details', {}, h('summary', {}, t('fit.paste')), h('label', { for: 'fit-text' }, t('fit.text')), paste),
        facts,
        h('h3', {}, t('fit.columns')), columns, h('p', { class: 'muted' }, t('fit.columnsHint')),
        h('h3', {}, t('fit.options')), options,
        h('p', {}, start), note),
      jobs,
      answer,
    ),
  };
};

function shown(context: PageContext, a: Answer): DocumentFragment {
  const unit = a.unit ?? 'min';
  const { table: read, groups, warnings, patch, provenance, library, unit: _, confidence: __, ...more } = a;
  const life = (groups ?? []).filter((g) => g.laws || g.not_fitted !== undefined);
  return fragment(
    section(t('fit.rows', { used: whole(read.rows_used), all: whole(read.rows_in_file) }), read.file,
      read.notes.length > 0 ? h('ul', {}, read.notes.map((n) => h('li', {}, n))) : null,
      read.dropped.length > 0 ? table(t('fit.dropped'), [
        { head: t('fit.line'), number: true, rowHead: true, cell: (d: { line: number; reason: string }) => d.line },
        { head: t('fit.dropped'), cell: (d: { line: number; reason: string }) => d.reason },
      ], read.dropped) : null,
      (warnings ?? []).map((w) => h('p', { class: 'warn' }, w))),
    patch ? patchSection(read.file, patch) : null,
    library ? librarySection(library) : null,
    life.length > 0 && life.every((g) => 'edges' in g) ? life.map((g) => groupSection(context, g, unit)) : null,
    blocks(life.length > 0 ? more : { ...more, groups }).map(blockSection),
  );
}

function groupSection(context: PageContext, g: Group, unit: string): HTMLElement {
  const name = [g.tool, g.regime].filter(Boolean).join(', ') || t('fit.allEdges');
  const plot = g.weibull_plot;
  return section(name, t('fit.edges', { edges: whole(g.edges), failures: whole(g.failures) }),
    g.not_fitted ? h('p', { class: 'warn' }, g.not_fitted) : null,
    g.best ? h('p', {}, t('fit.best', { law: g.best.family, mean: bounds(g.best.mean), share: significant(100 * g.best.gamma, 3), life: bounds(g.best.gamma_percent_life), unit })) : null,
    h('div', { class: 'columns even' },
      g.laws ? table<Law>(t('fit.laws', { name }), [
        { head: t('fit.law'), rowHead: true, cell: (l) => l.family },
        { head: t('fit.mean'), unit, number: true, cell: (l) => number(l.life_mean), raw: (l) => l.life_mean },
        { head: 'CV', number: true, cell: (l) => number(l.life_cv, 3), raw: (l) => l.life_cv },
        { head: 'AICc', number: true, cell: (l) => number(l.aicc, 5), raw: (l) => l.aicc },
        { head: t('fit.p'), number: true, cell: (l) => number(l.goodness_of_fit?.p_value, 3), raw: (l) => l.goodness_of_fit?.p_value ?? null },
      ], g.laws) : null,
      plot && plot.points.length > 1 ? chart(context, t('fit.weibull', { name }), 'large', (theme) => weibullOption(plot.points, plot.line, unit, { life: t('fit.life'), failed: t('fit.failed'), line: t('fit.lineOf', { shape: number(plot.line?.shape, 3), scale: number(plot.line?.scale) }), bounds: t('fit.ranks') }, theme), { name: t('fit.weibull', { name }), data: () => [['life', 'median rank', '5 %', '95 %'], ...plot.points.map((p) => [p.life, p.median_rank, p.low_5, p.high_95])] }).element : null));
}

function patchSection(file: string, patch: NonNullable<Answer['patch']>): HTMLElement {
  const note = h('p', { class: 'bad', role: 'alert' });
  const use = (open: () => Promise<void>) => () => {
    note.textContent = '';
    open().then(() => (location.hash = '#/scenario'), (e: unknown) => (note.textContent = e instanceof Error && e.message ? e.message : t('state.offline')));
  };
  const draft = recall();
  const pick = h('select', { id: 'fit-scenario', 'aria-label': t('scenario.choose') }, gallery.filter((g) => g.kind === 'scenario').map((g) => h('option', { value: g.name }, title(g.name.replace(/-/g, ' ')))));
  const intoDraft = use(async () => {
    const d = recall();
    if (d) remember(changed(d, file, applyChanges(current(d), patch.changes)));
  });
  const intoGallery = use(async () => {
    const item = gallery.find((g) => g.kind === 'scenario' && g.name === pick.value);
    if (!item) return;
    const text = await galleryText(item);
    const json = JSON.parse(text) as Json;
    remember(changed(begin(item.name, text, json, json), file, applyChanges(json, patch.changes)));
  });
  return section(t('fit.patch'), '',
    table<Change>(t('fit.patch'), [
      { head: t('scenario.place'), rowHead: true, cell: (c) => h('code', {}, c.pointer) },
      { head: t('col.value'), cell: (c) => brief(c.value), raw: (c) => (typeof c.value === 'number' ? c.value : JSON.stringify(c.value)) },
    ], patch.changes),
    h('p', { class: 'row no-print' },
      draft ? h('button', { type: 'button', id: 'fit-use-draft', onclick: intoDraft }, t('fit.useDraft', { name: draft.origin })) : null,
      pick, h('button', { type: 'button', id: 'fit-use', onclick: intoGallery }, t('fit.use')),
      h('button', { type: 'button', class: 'quiet', onclick: () => saveBlob(new Blob([`${JSON.stringify(patch, null, 2)}\n`], { type: 'application/json' }), 'changes.json') }, t('fit.save'))),
    h('p', { class: 'muted' }, t('fit.saveHint')),
    note);
}

function librarySection(entries: NonNullable<Answer['library']>): HTMLElement {
  return section(t('fit.library'), '',
    table<(typeof entries)[number]>(t('fit.library'), [
      { head: t('col.name'), rowHead: true, cell: (e) => e.name },
      { head: t('fit.kind'), cell: (e) => e.kind },
      { head: t('fit.method'), cell: (e) => e.provenance.method },
      { head: '', cell: (e) => h('button', { type: 'button', class: 'quiet no-print', 'data-entry': `${e.kind}-${e.name}`, onclick: () => saveBlob(new Blob([`${JSON.stringify(e, null, 2)}\n`], { type: 'application/json' }), `${e.kind}-${e.name.replace(/[^\p{L}\p{N}.-]/gu, '_')}.json`) }, t('fit.save')), raw: () => '' },
    ], entries),
    h('p', { class: 'muted' }, t('fit.libraryHint')));
}

function blockSection(block: Block): Child {
  const head = block.name === '' ? t('study.more') : block.name.split('/').map((n) => title(n)).join(': ');
  const value = (v: unknown): string => (v === undefined || v === null ? '–' : typeof v === 'number' ? significant(v) : typeof v === 'boolean' ? t(v ? 'yes' : ('no' as Key)) : String(v));
  return section(head, '', block.facts.length > 0
    ? table<Block['facts'][number]>(head, [{ head: t('col.name'), rowHead: true, cell: ([k]) => title(k) }, { head: t('col.value'), cell: ([, v]) => value(v), raw: ([, v]) => v }], block.facts)
    : table<Block['rows'][number]>(head, block.columns.map((c, k) => ({ head: title(c), number: block.rows.some((r) => typeof r[c] === 'number'), rowHead: k === 0, cell: (r: Block['rows'][number]) => value(r[c]), raw: (r: Block['rows'][number]) => r[c] })), block.rows.slice(0, 200)));
}
