// One operation: pick a kind or an example, move its numbers, see the plan that follows.

import { api, ApiError } from '../api';
import { chart } from '../charts/chart';
import { sweepOption } from '../charts/sweep';
import { fragment, h, table } from '../dom';
import { significant, unitText } from '../format';
import { gallery, galleryJson } from '../gallery';
import { t } from '../i18n';
import { remember, recall, changed, current } from '../logic/draft';
import { put, type Json } from '../logic/pointer';
import { findProperty, firstValue, meaningAndUnit, resolve, searchBounds, title } from '../logic/schema';
import { section, type PageMaker } from '../page';
import type { Band, CutPlan, JsonSchema, Kind, Limit, Quantity, SweepResult } from '../types';
import { SchemaForm } from '../ui/form';

/** Origins name functions of the catalogue: those become links. */
function originCell(origin: string | undefined): Node {
  if (!origin) return fragment('–');
  const parts = origin.split(/([KS]\d+\.\w+)/);
  return h('span', { class: 'muted origin' }, parts.map((p, k) => (k % 2 === 1 ? h('a', { href: `#/models/${p}` }, p) : p)));
}

function limitBar(limit: Limit): HTMLElement {
  const allowed = limit.at_most ?? limit.at_least ?? 0;
  const share = allowed === 0 ? (limit.met ? 0 : 1) : limit.at_most !== undefined ? limit.value / allowed : allowed / Math.max(limit.value, 1e-12);
  const bar = h('span', { class: `limit-bar ${limit.met ? '' : 'over'}`, 'aria-hidden': 'true' }, h('span', {}));
  (bar.firstChild as HTMLElement).style.width = `${Math.min(100, Math.max(0, 100 * share))}%`;
  return bar;
}

function bandBar(band: Band): HTMLElement {
  const low = Math.min(band.value, band.low) * 0.95;
  const high = Math.max(band.value, band.high) * 1.05;
  const place = (v: number) => `${(100 * (v - low)) / Math.max(high - low, 1e-12)}%`;
  const bar = h('span', { class: `band-bar ${band.inside ? 'over' : ''}`, 'aria-hidden': 'true' }, h('span', { class: 'forbidden' }), h('span', { class: 'here' }));
  const [forbidden, here] = [...bar.children] as HTMLElement[];
  if (forbidden && here) {
    forbidden.style.left = place(band.low);
    forbidden.style.width = `${(100 * (band.high - band.low)) / Math.max(high - low, 1e-12)}%`;
    here.style.left = place(band.value);
  }
  return bar;
}

function planView(plan: CutPlan): DocumentFragment {
  const quantityTable = (name: string, list: Quantity[]) =>
    table<Quantity>(
      name,
      [
        { head: t('col.name'), rowHead: true, cell: (q) => h('span', { title: q.meaning }, title(q.name, q.unit)), raw: (q) => q.name },
        { head: t('col.value'), number: true, cell: (q) => h('output', { 'data-quantity': q.name }, significant(q.value)), raw: (q) => q.value },
        { head: t('col.unit'), cell: (q) => h('span', { class: 'unit' }, unitText(q.unit) || '1'), raw: (q) => q.unit },
        { head: t('plan.origin'), cell: (q) => originCell(q.origin), raw: (q) => q.origin },
      ],
      list,
    );
  const lives = [...(plan.edge_life ? [plan.edge_life] : []), ...plan.more_elements];
  return fragment(
    h('p', { class: `verdict-line ${plan.feasible ? 'good' : 'bad'}`, id: 'plan-verdict' }, plan.feasible ? t('plan.feasible') : t('plan.infeasible')),
    h(
      'dl',
      { class: 'tiles' },
      h('div', { class: 'tile' }, h('dt', {}, t('plan.time')), h('dd', {}, h('span', { class: 'value', id: 'plan-time' }, significant(plan.main_time_min)), h('span', { class: 'unit' }, ' min'))),
      lives.map((l) => h('div', { class: 'tile' }, h('dt', {}, t('plan.life', { element: l.element })), h('dd', {}, h('span', { class: 'value' }, significant(l.mean_min)), h('span', { class: 'unit' }, ' min')), h('dd', { class: 'below', title: l.origin }, `${l.law}, CV ${significant(l.cv)}`))),
      plan.scrap_probability > 0 ? h('div', { class: 'tile' }, h('dt', {}, t('plan.scrap')), h('dd', {}, h('span', { class: 'value' }, significant(100 * plan.scrap_probability, 4)), h('span', { class: 'unit' }, ' %'))) : null,
      plan.breakage_probability > 0 ? h('div', { class: 'tile' }, h('dt', {}, t('plan.breakage')), h('dd', {}, h('span', { class: 'value' }, significant(100 * plan.breakage_probability, 4)), h('span', { class: 'unit' }, ' %'))) : null,
    ),
    plan.limits.length > 0
      ? [
          h('h3', {}, t('plan.limits')),
          table<Limit>(
            t('plan.limits'),
            [
              { head: t('col.name'), rowHead: true, cell: (l) => title(l.name, l.unit), raw: (l) => l.name },
              { head: t('col.value'), number: true, cell: (l) => significant(l.value), raw: (l) => l.value },
              { head: t('plan.allowed'), number: true, cell: (l) => (l.at_most !== undefined ? `≤ ${significant(l.at_most)}` : `≥ ${significant(l.at_least ?? 0)}`), raw: (l) => l.at_most ?? l.at_least },
              { head: t('col.unit'), cell: (l) => h('span', { class: 'unit' }, unitText(l.unit) || '1') },
              { head: t('plan.margin'), unit: '%', number: true, cell: (l) => h('span', { class: l.met ? undefined : 'bad' }, significant(100 * l.margin, 3)), raw: (l) => 100 * l.margin },
              { head: t('plan.used'), cell: limitBar, raw: (l) => (l.met ? 'ok' : 'over') },
              { head: t('plan.origin'), cell: (l) => originCell(l.origin), raw: (l) => l.origin },
            ],
            plan.limits,
          ),
        ]
      : null,
    plan.forbidden_bands.length > 0
      ? [
          h('h3', {}, t('plan.bands')),
          table<Band>(
            t('plan.bands'),
            [
              { head: t('col.name'), rowHead: true, cell: (b) => title(b.name, b.unit), raw: (b) => b.name },
              { head: t('col.value'), number: true, cell: (b) => h('span', { class: b.inside ? 'bad' : undefined }, significant(b.value)), raw: (b) => b.value },
              { head: t('plan.forbidden'), number: true, cell: (b) => `${significant(b.low)} … ${significant(b.high)}` },
              { head: t('col.unit'), cell: (b) => h('span', { class: 'unit' }, unitText(b.unit) || '1') },
              { head: t('plan.used'), cell: bandBar, raw: (b) => (b.inside ? 'inside' : 'outside') },
              { head: t('plan.origin'), cell: (b) => originCell(b.origin), raw: (b) => b.origin },
            ],
            plan.forbidden_bands,
          ),
        ]
      : null,
    h('h3', {}, t('plan.quantities')),
    quantityTable(t('plan.quantities'), plan.quantities),
    plan.consumables.length > 0 ? [h('h3', {}, t('plan.consumables')), quantityTable(t('plan.consumables'), plan.consumables)] : null,
  );
}

export const operationsPage: PageMaker = async (context, [chosen = '']) => {
  const [{ kinds }, schema] = await Promise.all([api.kinds(context.signal), api.schema(context.signal)]);
  const examples = gallery.filter((g) => g.kind === 'operation');
  const example = examples.find((g) => g.name === chosen) ?? (kinds.some((k) => k.name === chosen) ? undefined : (examples.find((g) => g.name === 'turning') ?? examples[0]));
  const kindNamed = (name: string): Kind | undefined => kinds.find((k) => k.name === name);

  let operation: Json = example ? await galleryJson(example, context.signal) : { process: blank(kindNamed(chosen)) };
  function blank(kind: Kind | undefined): Json {
    const value = firstValue(schema, kind?.schema ?? {});
    return typeof value === 'object' && !Array.isArray(value) && value !== null ? { kind: kind?.name ?? '', ...value } : value;
  }
  const process = () => (operation as { process?: { kind?: string } }).process;
  const kind = kindNamed(process()?.kind ?? '');
  const about = (operation as { description?: string }).description ?? '';
  const lifeSchema = findProperty(schema, 'edge_life');
  const limitSchema = findProperty(schema, 'limits');
  const { default: _process, ...processSchema } = resolve(schema, kind?.schema ?? {});
  const root: JsonSchema = {
    ...schema,
    type: 'object',
    required: ['process'],
    properties: {
      process: { ...processSchema, description: kind?.summary ?? '' },
      ...(lifeSchema ? { edge_life: { ...resolve(schema, lifeSchema) } } : {}),
      ...(limitSchema ? { machine_limits: { ...resolve(schema, limitSchema) } } : {}),
    },
  };

  const plan = h('div', { id: 'plan', 'aria-live': 'off' });
  const note = h('p', { class: 'bad', role: 'alert', id: 'plan-error' });
  let abort = new AbortController();
  let timer = 0;
  let swept: { pointer: string; schema: JsonSchema } | undefined;
  let sweep: SweepResult | undefined;
  let shown = '';
  const curve = h('div', { id: 'sweep' });
  const hidden: (() => void)[] = [];

  const replan = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => void planNow(), 80);
  };
  const planNow = async () => {
    abort.abort();
    abort = new AbortController();
    const { signal } = abort;
    form.clearErrors();
    note.textContent = '';
    try {
      plan.replaceChildren(planView(await api.plan({ operation }, signal)));
      plan.classList.remove('stale');
      if (swept) await sweepNow(signal);
    } catch (e) {
      if (signal.aborted || !(e instanceof ApiError)) return;
      plan.classList.add('stale');
      const words = e.message || t('state.offline');
      // Models blame an input by its name, the loader a place by its pointer.
      const place = e.pointer || (e.input ? `/process/${e.input}` : '');
      if (!place || !form.showError(place, words)) note.textContent = words;
    }
  };
  const sweepNow = async (signal: AbortSignal) => {
    if (!swept) return;
    const value = numberAt(swept.pointer);
    const { low, high } = searchBounds(swept.schema, value);
    const values = Array.from({ length: 81 }, (_, k) => low + ((high - low) * k) / 80);
    sweep = await api.planSweep({ operation }, swept.pointer, swept.schema.type === 'integer' ? [...new Set(values.map(Math.round))] : values, signal);
    drawCurve();
  };
  const numberAt = (pointer: string): number => {
    let here: unknown = operation;
    for (const step of pointer.slice(1).split('/')) here = (here as Record<string, unknown> | undefined)?.[step];
    return typeof here === 'number' ? here : 0;
  };
  function drawCurve(): void {
    hidden.splice(0).forEach((f) => f());
    if (!sweep || !swept) return curve.replaceChildren();
    const points = sweep.points;
    const names = [...new Set(points.flatMap((p) => Object.keys(p.quantities ?? {})))];
    if (!names.includes(shown)) shown = names.includes('main_time_min') ? 'main_time_min' : (names[0] ?? '');
    const { unit } = meaningAndUnit(swept.schema);
    const name = title(swept.pointer.slice(swept.pointer.lastIndexOf('/') + 1), unit);
    const now = numberAt(swept.pointer);
    const drawers: (() => void)[] = [];
    const inner = { signal: context.signal, whenShown: (d: () => void) => drawers.push(d), whenLeft: (c: () => void) => hidden.push(c) };
    const picture = chart(inner, t('plan.curveOf', { y: title(shown), x: name }), 'medium', (theme) => sweepOption(points, shown, name, unitText(unit), now, theme), {
      name: `${shown}-${name}`,
      data: () => [[name, ...names, t('plan.feasible')], ...points.map((p) => [p.value, ...names.map((n) => p.quantities?.[n] ?? null), p.feasible ?? p.error ?? null])],
    });
    const select = h('select', { id: 'sweep-y', onchange: () => { shown = select.value; drawCurve(); } }, names.map((n) => h('option', { value: n, selected: n === shown }, title(n))));
    curve.replaceChildren(section(t('plan.curve', { x: name }), unitText(unit), h('p', { class: 'row no-print' }, h('label', { for: 'sweep-y' }, t('plan.show')), select), picture.element, h('p', { class: 'muted' }, t('plan.curveHint'))));
    drawers.forEach((d) => d());
  }
  context.whenLeft(() => {
    abort.abort();
    clearTimeout(timer);
    hidden.forEach((f) => f());
  });

  const form = new SchemaForm({
    root,
    document: () => operation,
    open: new Set(['/process']),
    onChange: (pointer, value) => {
      operation = put(operation, pointer, value);
      replan();
    },
    beside: (pointer, member, value) => {
      const { low, high } = searchBounds(member, value);
      const slider = h('input', {
        type: 'range', min: low, max: high, step: member.type === 'integer' ? 1 : 'any', value, 'aria-label': t('plan.move', { name: title(pointer.slice(pointer.lastIndexOf('/') + 1)) }),
        oninput: () => {
          const next = member.type === 'integer' ? Math.round(Number(slider.value)) : Number(Number(slider.value).toPrecision(4));
          operation = put(operation, pointer, next);
          const box = slider.closest('.field')?.querySelector<HTMLInputElement>('input[type=text]');
          if (box) box.value = String(next);
          replan();
        },
      });
      const button = h('button', { type: 'button', class: 'quiet small', onclick: () => { swept = { pointer, schema: member }; replan(); } }, t('plan.curveButton'));
      return h('span', { class: 'slide' }, slider, ' ', button);
    },
  });

  const pick = h(
    'select',
    { id: 'operation-pick', onchange: () => (location.hash = `#/operations/${pick.value}`) },
    h('optgroup', { label: t('plan.examples') }, examples.map((g) => h('option', { value: g.name, selected: g === example }, title(g.name)))),
    h('optgroup', { label: t('plan.blank') }, kinds.filter((k) => !examples.some((g) => g.name === k.name)).map((k) => h('option', { value: k.name, selected: !example && k.name === chosen }, title(k.name)))),
  );
  const use = h('button', { type: 'button', class: 'quiet', onclick: () => {
    const draft = recall();
    if (!draft) return void (location.hash = '#/scenario');
    const scenario = current(draft) as { operations?: Json[] };
    const operations = scenario.operations ?? [];
    const first = operations[0];
    const machine = typeof first === 'object' && first !== null && !Array.isArray(first) ? { machine: first['machine'] ?? '' } : {};
    const names = new Set(operations.map((o) => (o as { name?: string }).name));
    let name = title(process()?.kind ?? 'operation');
    for (let k = 2; names.has(name); ++k) name = `${title(process()?.kind ?? 'operation')} ${k}`;
    remember(changed(draft, '/operations', put(current(draft), '/operations', [...operations, { name, ...machine, process: (operation as { process: Json }).process }])));
    location.hash = '#/scenario';
  } }, t('plan.use'));
  void planNow();
  return {
    title: t('nav.operations'),
    body: fragment(
      h('h1', {}, t('nav.operations')),
      h('p', { class: 'row no-print' }, h('label', { for: 'operation-pick' }, t('plan.pick')), pick, use),
      kind ? h('p', {}, h('strong', {}, kind.summary), ' ', h('span', { class: 'muted' }, kind.sources.join(', '))) : null,
      about ? h('p', { class: 'muted' }, about) : null,
      h('div', { class: 'columns even' }, section(t('plan.spec'), '', note, form.element), section(t('plan.plan'), '', plan)),
      curve,
    ),
  };
};
