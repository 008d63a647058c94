// The scenario: the shop as a graph, as forms and as text; change it, run it, compare, set up a study - all in one place.

import { api, ApiError, saveBlob } from '../api';
import { drawShop } from '../charts/shopGraph';
import { fragment, h, table } from '../dom';
import { estimateText, unitText } from '../format';
import { gallery, galleryText } from '../gallery';
import { named, t } from '../i18n';
import { begin, changed, current, moved, recall, remember, request, type Draft } from '../logic/draft';
import { shopGraph } from '../logic/graph';
import { parseNumber } from '../logic/fields';
import { applyChanges, at, changesBetween, put, type Json } from '../logic/pointer';
import { meaningAndUnit, searchBounds, title } from '../logic/schema';
import { difference } from '../logic/statistics';
import { section, type PageContext, type PageMaker } from '../page';
import type { Job, JsonSchema, Kpi, Run } from '../types';
import { SchemaForm } from '../ui/form';
import { activeJobs, jobPanel } from '../ui/job';

async function openOrigin(origin: string, id: string, signal: AbortSignal): Promise<Draft | undefined> {
  if (origin === 'run') {
    const stored = await api.runScenario(id, signal);
    const base = JSON.parse(stored.scenario) as Json;
    return { ...begin(t('run.title', { id }), stored.scenario, base, applyChanges(base, stored.changes)), runs: [stored.run] };
  }
  const item = gallery.find((g) => g.kind === 'scenario' && g.name === id);
  if (origin !== 'gallery' || !item) return undefined;
  const text = await galleryText(item, signal);
  const json = JSON.parse(text) as Json;
  return begin(item.name, text, json, json);
}

interface StudyVariable {
  name: string;
  pointer: string;
  unit: string;
  low: number;
  high: number;
}

/** A name that tells a pointer's number from its neighbours: "roughing tool: gamma". */
export function variableName(scenario: Json, pointer: string): string {
  const steps = pointer.slice(1).split('/');
  const leaf = title(steps.at(-1) ?? '');
  for (let n = steps.length - 1; n > 0; --n) {
    const owner = at(scenario, `/${steps.slice(0, n).join('/')}/name`);
    if (typeof owner === 'string' && owner !== '') return `${owner}: ${leaf}`;
  }
  return leaf;
}

/** The KPIs that stand above all machines and tools, money and output first. */
export function headline(kpis: readonly Kpi[]): Kpi[] {
  return kpis.filter((k) => !k.name.includes('/')).slice(0, 8);
}

export const scenarioPage: PageMaker = async (context, [origin = '', id = '']) => {
  const [schema, version] = await Promise.all([api.schema(context.signal), api.version(context.signal)]);
  let draft = origin ? await openOrigin(origin, id, context.signal) : recall();
  if (origin && draft) {
    remember(draft);
    history.replaceState(null, '', '#/scenario');
  }
  const chooser = openChooser((opened) => {
    remember(opened);
    dispatchEvent(new HashChangeEvent('hashchange'));
  });
  if (!draft)
    return { title: t('nav.scenario'), body: fragment(h('h1', {}, t('nav.scenario')), section(t('scenario.choose'), '', chooser)) };
  return { title: t('nav.scenario'), body: workbench(context, schema, draft, chooser, version.read_only) };
};

function openChooser(open: (draft: Draft) => void): HTMLElement {
  const note = h('p', { class: 'bad', role: 'alert' });
  const pick = h('select', { id: 'gallery-pick' }, gallery.filter((g) => g.kind === 'scenario').map((g) => h('option', { value: g.name }, title(g.name.replace(/-/g, ' ')))));
  const file = h('input', {
    id: 'scenario-file', type: 'file', accept: '.json,application/json',
    onchange: () => {
      const chosen = file.files?.[0];
      if (!chosen) return;
      note.textContent = '';
      void chosen.text().then((text) => {
        file.value = ''; // the same file may be chosen again when it has changed
        try {
          const json = JSON.parse(text) as Json;
          open(begin(chosen.name, text, json, json));
        } catch (e) {
          note.textContent = `${chosen.name}: ${String(e)}`;
        }
      });
    },
  });
  return h(
    'div',
    {},
    h('p', { class: 'row' }, h('label', { for: 'gallery-pick' }, t('scenario.gallery')), pick, h('button', { type: 'button', onclick: () => (location.hash = `#/scenario/gallery/${pick.value}`) }, t('scenario.open'))),
    h('p', { class: 'row' }, h('label', { for: 'scenario-file' }, t('scenario.file')), file),
    h('p', { class: 'muted' }, t('scenario.orRun'), ' ', h('a', { href: '#/' }, t('nav.home'))),
    note,
  );
}

function workbench(context: PageContext, schema: JsonSchema, first: Draft, chooser: HTMLElement, readOnly: boolean): DocumentFragment {
  let draft = first;
  const variables = new Map<string, StudyVariable>();
  let choosing = false;

  const graph = h('div', { id: 'shop-graph' });
  const text = h('textarea', { id: 'scenario-text', spellcheck: 'false', rows: 30, 'aria-label': t('scenario.text'), 'aria-describedby': 'text-error' });
  const textError = h('p', { class: 'bad', role: 'alert', id: 'text-error' });
  const status = h('p', { id: 'check', role: 'status', class: 'check' });
  const heading = h('h1', {});
  const historyPlace = h('div', { id: 'history' });
  const jobs = h('div', { id: 'jobs' });
  const results = h('div', { id: 'results' });
  const studyPlace = h('div', { id: 'study-setup' });

  // ------------------------------------------------------------------------------------ what is shown follows the draft
  const now = () => current(draft);
  const setDraft = (next: Draft, from: 'form' | 'text' | 'history') => {
    draft = next;
    remember(draft);
    if (from !== 'text') {
      text.value = JSON.stringify(now(), null, 2);
      textError.textContent = '';
    }
    if (from !== 'form') form.redraw();
    drawSmall();
    check();
  };
  const drawSmall = () => {
    const json = now() as { name?: string } | null;
    heading.replaceChildren(String(json?.name ?? t('nav.scenario')), h('span', { class: 'unit' }, ` ${draft.origin}`));
    graph.replaceChildren(drawShop(shopGraph(now()), (pointer) => form.reveal(pointer)));
    const changes = changesBetween(draft.base, now());
    const short = (value: unknown) => {
      const words = JSON.stringify(value);
      return words.length > 60 ? `${words.slice(0, 57)}…` : words;
    };
    historyPlace.replaceChildren(
      h('p', { class: 'row no-print' },
        h('button', { type: 'button', class: 'quiet', disabled: draft.position === 0, onclick: () => setDraft(moved(draft, draft.position - 1), 'history') }, t('scenario.undo')),
        h('button', { type: 'button', class: 'quiet', disabled: draft.position >= draft.history.length - 1, onclick: () => setDraft(moved(draft, draft.position + 1), 'history') }, t('scenario.redo')),
        h('button', { type: 'button', class: 'quiet', disabled: changes.length === 0, onclick: () => setDraft(changed(draft, t('scenario.reset'), draft.base), 'history') }, t('scenario.reset')),
        h('button', { type: 'button', class: 'quiet', onclick: () => saveText() }, t('scenario.save')),
      ),
      changes.length === 0
        ? h('p', { class: 'muted' }, t('scenario.unchanged'))
        : table(t('scenario.changes'), [
            { head: t('scenario.place'), rowHead: true, cell: (c) => h('code', {}, c.pointer || '/') },
            { head: t('scenario.was'), cell: (c) => h('code', {}, short(at(draft.base, c.pointer) ?? null)) },
            { head: t('scenario.is'), cell: (c) => h('code', {}, short(c.value)) },
          ], changes.slice(0, 100)),
      h('details', {}, h('summary', {}, t('scenario.steps', { n: draft.history.length - 1 })),
        h('ol', { class: 'steps' }, draft.history.map((s, k) => h('li', {}, h('button', { type: 'button', class: 'quiet small', 'aria-current': k === draft.position ? 'step' : undefined, onclick: () => setDraft(moved(draft, k), 'history') }, s.what))))),
    );
  };
  const saveText = () => {
    saveBlob(new Blob([`${JSON.stringify(now(), null, 2)}\n`], { type: 'application/json' }), 'scenario.json');
  };

  const form = new SchemaForm({
    root: schema,
    document: now,
    open: new Set(),
    onChange: (pointer, value) => setDraft(changed(draft, pointer, put(now(), pointer, value)), 'form'),
    beside: (pointer, member, value) => {
      if (!choosing) return null;
      const box = h('input', {
        type: 'checkbox', checked: variables.has(pointer), 'aria-label': t('setup.vary', { name: variableName(now(), pointer) }),
        onchange: () => {
          if (box.checked) variables.set(pointer, { name: variableName(now(), pointer), pointer, unit: meaningAndUnit(member).unit || '1', ...searchBounds(member, value) });
          else variables.delete(pointer);
          drawStudy();
        },
      });
      return h('label', { class: 'vary' }, box, t('setup.varyShort'));
    },
  });

  text.addEventListener('input', () => {
    try {
      const json = JSON.parse(text.value) as Json;
      textError.textContent = '';
      setDraft(changed(draft, t('scenario.text'), json), 'text');
    } catch (e) {
      textError.textContent = String(e instanceof Error ? e.message : e);
      status.textContent = t('scenario.noJson');
      status.className = 'check bad';
    }
  });

  // ------------------------------------------------------------------------------------------------- the server checks
  let timer = 0;
  let abort = new AbortController();
  const check = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => void checkNow(), 250);
  };
  const refuse = (e: ApiError) => {
    const words = e.message || t('state.offline');
    status.textContent = words;
    status.className = 'check bad';
    if (e.pointer) form.showError(e.pointer, words);
  };
  const checkNow = async (): Promise<boolean> => {
    clearTimeout(timer);
    abort.abort();
    abort = new AbortController();
    const { signal } = abort;
    try {
      const { scenario, changes } = request(draft);
      const answer = await api.check(scenario, changes, signal);
      form.clearErrors();
      const over = answer.operations.filter((o) => o.feasible === false).map((o) => o.operation);
      const bad = answer.operations.filter((o) => o.error !== undefined);
      status.textContent = bad[0] ? `${bad[0].operation}: ${bad[0].error}` : over.length > 0 ? t('scenario.overLimits', { names: over.join(', ') }) : t('scenario.valid');
      status.className = `check ${bad[0] || over.length > 0 ? 'warn' : 'good'}`;
      return true;
    } catch (e) {
      if (!signal.aborted && e instanceof ApiError) {
        form.clearErrors();
        refuse(e);
      }
      return false;
    }
  };
  context.whenLeft(() => {
    clearTimeout(timer);
    abort.abort();
  });

  // --------------------------------------------------------------------------------------------------- run and compare
  const start = async (body: Record<string, unknown>) => {
    try {
      const job = await api.startJob({ ...body, ...request(draft) });
      jobs.prepend(jobPanel(context, job, ended));
      jobs.scrollIntoView({ block: 'nearest' });
    } catch (e) {
      if (e instanceof ApiError) refuse(e);
      else throw e;
    }
  };
  const ended = (job: Job) => {
    if (job.state !== 'finished' || !job.result) return;
    if (job.result.run !== undefined) {
      draft = { ...draft, runs: [...draft.runs, job.result.run] };
      remember(draft);
      void drawResults();
    }
    if (job.result.study !== undefined) document.querySelector(`[data-job="${job.id}"]`)?.append(h('p', {}, h('a', { href: `#/studies/${job.result.study}`, class: 'to-study' }, t('setup.open'))));
  };
  const drawResults = async () => {
    const wanted = draft.runs.slice(-6);
    if (wanted.length === 0) return results.replaceChildren(h('p', { class: 'muted' }, t('scenario.noRuns')));
    const runs = (await Promise.all(wanted.map((r) => api.run(String(r), true, context.signal).catch(() => undefined)))).filter((r): r is Run => r !== undefined);
    const [base] = runs;
    if (!base) return;
    const last = runs.at(-1) ?? base;
    const rows = headline(last.kpis);
    const cell = (run: Run, name: string) => {
      const kpi = run.kpis.find((k) => k.name === name);
      if (!kpi) return '–';
      if (run === base) return estimateText(kpi.mean, kpi.half_width_95);
      const before = base.kpis.find((k) => k.name === name);
      const d = before ? difference(before.values ?? [], kpi.values ?? [], run.seed === base.seed && run.replications === base.replications) : null;
      return [estimateText(kpi.mean, kpi.half_width_95), d ? h('span', { class: `below verdict ${d.verdict}`, title: t(`compare.${d.verdict}`) }, estimateText(d.mean, d.halfWidth)) : null];
    };
    results.replaceChildren(
      table<Kpi>(t('scenario.results'), [
        { head: t('col.name'), rowHead: true, cell: (k) => h('span', { title: k.meaning }, named('kpi', k.name)) },
        ...runs.map((run) => ({ head: h('a', { href: `#/runs/${run.id}` }, t('run.title', { id: run.id })), number: true, cell: (k: Kpi) => cell(run, k.name), raw: (k: Kpi) => run.kpis.find((x) => x.name === k.name)?.mean })),
        { head: t('col.unit'), cell: (k) => h('span', { class: 'unit' }, unitText(k.unit) || '1') },
      ], rows),
      runs.length > 1 ? h('p', {}, h('a', { href: `#/compare/${runs.map((r) => r.id).join('/')}` }, t('scenario.compareAll'))) : fragment(),
    );
  };
  const label = h('input', { id: 'run-label', type: 'text', value: '', maxlength: 80, placeholder: t('scenario.labelHint') });

  // --------------------------------------------------------------------------------------------------- setting up a study
  const direction = h('select', { id: 'study-direction', 'aria-label': t('setup.direction') }, h('option', { value: 'minimize' }, t('setup.minimize')), h('option', { value: 'maximize' }, t('setup.maximize')));
  const objective = h('input', { id: 'study-objective', type: 'text', value: 'cost_per_part', list: 'kpi-names' });
  const replications = h('input', { id: 'study-replications', type: 'text', inputmode: 'numeric', value: '40' });
  const studyText = h('textarea', { id: 'study-text', rows: 14, spellcheck: 'false', 'aria-label': t('setup.json') });
  const studyError = h('p', { class: 'bad', role: 'alert' });
  const compose = () => ({
    name: `${(now() as { name?: string } | null)?.name ?? ''}: ${[...variables.values()].map((v) => v.name).join(', ')}`.slice(0, 180),
    variables: [...variables.values()],
    objective: { kpi: objective.value.trim(), direction: direction.value },
    search: { max_evaluations: 4000, relative_precision: 1e-8 },
    confirmation: { replications: parseNumber(replications.value) ?? replications.value, confidence: 0.95 },
  });
  const bound = (v: StudyVariable, key: 'low' | 'high') => {
    const input = h('input', { type: 'text', inputmode: 'decimal', value: v[key], 'aria-label': t(`setup.${key}Of`, { name: v.name }), onchange: () => {
      const value = parseNumber(input.value);
      input.toggleAttribute('aria-invalid', false);
      studyError.textContent = '';
      if (value === null) {
        input.setAttribute('aria-invalid', 'true');
        studyError.textContent = `${t(`setup.${key}Of`, { name: v.name })}: ${t('models.bad.number')}`;
        return;
      }
      variables.set(v.pointer, { ...(variables.get(v.pointer) ?? v), [key]: value });
      studyText.value = JSON.stringify(compose(), null, 2);
    } });
    return input;
  };
  const drawStudy = () => {
    if (!choosing) return studyPlace.replaceChildren();
    for (const [pointer] of variables) if (typeof at(now(), pointer) !== 'number') variables.delete(pointer);
    studyText.value = JSON.stringify(compose(), null, 2);
    studyPlace.replaceChildren(
      section(t('setup.title'), '',
        h('p', { class: 'muted' }, t('setup.hint')),
        table<StudyVariable>(t('setup.variables'), [
          { head: t('col.variable'), rowHead: true, cell: (v) => h('span', { title: v.pointer }, v.name) },
          { head: t('col.today'), number: true, cell: (v) => String(at(now(), v.pointer) ?? '') },
          { head: t('setup.low'), cell: (v) => bound(v, 'low'), raw: (v) => v.low },
          { head: t('setup.high'), cell: (v) => bound(v, 'high'), raw: (v) => v.high },
          { head: t('col.unit'), cell: (v) => h('span', { class: 'unit' }, v.unit) },
        ], [...variables.values()]),
        h('p', { class: 'row' }, h('label', { for: 'study-objective' }, t('col.objective')), direction, objective, h('label', { for: 'study-replications' }, t('setup.replications')), replications),
        h('datalist', { id: 'kpi-names' }),
        h('details', {}, h('summary', {}, t('setup.json')), h('p', { class: 'muted' }, t('setup.jsonHint')), studyText),
        studyError,
        h('p', {}, h('button', { type: 'button', id: 'start-study', disabled: readOnly || variables.size === 0, onclick: () => {
          studyError.textContent = '';
          try {
            void start({ kind: 'study', study: JSON.parse(studyText.value) as unknown });
          } catch (e) {
            studyError.textContent = String(e);
          }
        } }, t('setup.start')))),
    );
    const last = draft.runs.at(-1);
    if (last !== undefined)
      void api.run(String(last), false, context.signal).then((run) => document.getElementById('kpi-names')?.replaceChildren(...run.kpis.map((k) => h('option', { value: k.name }, k.meaning)))).catch(() => undefined);
  };
  for (const input of [objective, replications, direction]) input.addEventListener('change', () => (studyText.value = JSON.stringify(compose(), null, 2)));

  const studyButton = h('button', { type: 'button', class: 'quiet', 'aria-pressed': 'false', onclick: () => {
    choosing = !choosing;
    studyButton.setAttribute('aria-pressed', String(choosing));
    form.redraw();
    drawStudy();
  } }, t('setup.choose'));

  text.value = JSON.stringify(now(), null, 2);
  drawSmall();
  check();
  void drawResults();
  // Jobs started before one looked elsewhere.
  activeJobs(context, ['run', 'study'], ended).then((panels) => jobs.append(...panels), () => undefined);
  return fragment(
    heading,
    h('div', { class: 'bar no-print' },
      h('button', { type: 'button', id: 'start-run', disabled: readOnly, onclick: () => void start({ kind: 'run', label: label.value.trim() || 'what-if' }) }, t('scenario.run')),
      h('label', { for: 'run-label' }, t('col.label')), label, studyButton, status),
    readOnly ? h('p', { class: 'muted' }, t('state.readOnly')) : null,
    jobs,
    section(t('scenario.graph'), '', graph),
    section(t('scenario.results'), '', results),
    studyPlace,
    h('div', { class: 'columns even' }, section(t('scenario.form'), '', form.element), section(t('scenario.text'), 'JSON', textError, text)),
    section(t('scenario.changes'), '', historyPlace),
    section(t('scenario.other'), '', chooser),
  );
}
