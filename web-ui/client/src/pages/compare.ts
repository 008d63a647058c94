// Two or more runs side by side: each against the first, with paired differences when they share their random numbers.

import { api } from '../api';
import { fragment, h, table } from '../dom';
import { estimateText, unitText } from '../format';
import { named, t } from '../i18n';
import { difference, type Difference } from '../logic/statistics';
import { changeList, section, type PageMaker } from '../page';
import type { Kpi, Run } from '../types';

interface Row {
  kpi: Kpi;
  of: (Kpi | undefined)[];
  differences: (Difference | null)[];
}

export const comparePage: PageMaker = async (context, [list = '']) => {
  const ids = list.split('/');
  const runs = await Promise.all(ids.map((id) => api.run(id, true, context.signal)));
  const base = runs[0] as Run;
  const others = runs.slice(1);
  const paired = (run: Run) => run.seed === base.seed && run.replications === base.replications;
  const names = [...new Map(runs.flatMap((r) => r.kpis).map((k) => [k.name, k])).values()];
  const rows: Row[] = names
    .map((kpi) => {
      const of = runs.map((r) => r.kpis.find((k) => k.name === kpi.name));
      const a = of[0];
      return { kpi, of, differences: others.map((run, k) => { const b = of[k + 1]; return a && b ? difference(a.values ?? [], b.values ?? [], paired(run)) : null; }) };
    })
    // What is nought in all says nothing.
    .filter((r) => !r.of.every((k) => k?.mean === 0));
  const head = others.length === 1 ? t('compare.title', { a: base.id, b: others[0]?.id ?? '' }) : t('compare.many', { n: runs.length });
  const currencies = [...new Set(runs.map((r) => r.currency))];
  const place = h('div');
  const show = (words: string, clear: boolean) => {
    const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
    const shown = rows.filter((r) => wanted.every((w) => `${r.kpi.name} ${r.kpi.meaning} ${named('kpi', r.kpi.name)}`.toLowerCase().includes(w)) && (!clear || r.differences.some((d) => d?.verdict === 'higher' || d?.verdict === 'lower')));
    place.replaceChildren(
      table<Row>(
        head,
        [
          { head: t('col.name'), rowHead: true, cell: (r) => h('code', { title: r.kpi.meaning }, r.kpi.name) },
          ...runs.map((run, k) => ({ head: t('compare.run', { id: run.id }), number: true, cell: (r: Row) => estimateText(r.of[k]?.mean, r.of[k]?.half_width_95), raw: (r: Row) => r.of[k]?.mean })),
          ...others.map((run, k) => ({
            head: others.length === 1 ? t('col.difference') : t('compare.against', { a: base.id, b: run.id }),
            number: true,
            cell: (r: Row) => { const d = r.differences[k]; return d ? estimateText(d.mean, d.halfWidth) : '–'; },
            raw: (r: Row) => r.differences[k]?.mean,
          })),
          { head: t('col.unit'), cell: (r) => h('span', { class: 'unit' }, unitText(r.kpi.unit) || '1') },
          ...others.map((_run, k) => ({ head: `${t('col.verdict')} (95 %)`, cell: (r: Row) => { const d = r.differences[k]; return d ? h('span', { class: `verdict ${d.verdict}` }, t(`compare.${d.verdict}`)) : '–'; } })),
        ],
        shown,
      ),
    );
  };
  const filter = h('input', { id: 'compare-filter', type: 'search', oninput: () => show(filter.value, only.checked) });
  const only = h('input', { id: 'compare-clear', type: 'checkbox', onchange: () => show(filter.value, only.checked) });
  show('', false);
  return {
    title: head,
    body: fragment(
      h('h1', {}, head),
      h('p', {}, runs.map((run, k) => [k > 0 ? h('br') : null, h('a', { href: `#/runs/${run.id}` }, t('compare.run', { id: run.id })), `: ${run.scenario}, ${run.label}${changeWords(run)}`])),
      h('p', { class: 'muted' }, others.every(paired) ? t('compare.paired', { seed: base.seed }) : t('compare.unpaired')),
      currencies.length > 1 ? h('p', { class: 'bad' }, t('compare.currency', { a: currencies[0] ?? '', b: currencies[1] ?? '' })) : null,
      section(t('run.all'), '', h('p', { class: 'row no-print' }, h('label', { for: 'compare-filter' }, t('run.filter')), filter, h('label', {}, only, ' ', t('compare.onlyClear'))), place),
    ),
  };
};

function changeWords(run: Run): string {
  const list = changeList(run.changes);
  return list.length > 0 ? ` (${list.map((c) => `${c.pointer} = ${c.value}`).join(', ').slice(0, 200)})` : '';
}
