// The shop drawn: machines as boxes that lead to their place in the form.

import { h, svg } from '../dom';
import { t } from '../i18n';
import type { ShopGraph, ShopNode } from '../logic/graph';

const wide = 150;
const high = 46;
const gapX = 56;
const gapY = 16;

export function drawShop(graph: ShopGraph, open: (pointer: string) => void): HTMLElement {
  if (graph.nodes.length === 0) return h('p', { class: 'muted' }, t('scenario.noGraph'));
  const columns = Math.max(...graph.nodes.map((n) => n.column)) + 1;
  const perColumn = (c: number) => graph.nodes.filter((n) => n.column === c).length;
  const rows = Math.max(...graph.nodes.map((n) => perColumn(n.column)));
  const height = rows * (high + gapY) + gapY;
  const width = columns * (wide + gapX) - gapX + 20;
  const x = (n: ShopNode) => 10 + n.column * (wide + gapX);
  const y = (n: ShopNode) => (height - perColumn(n.column) * (high + gapY) + gapY) / 2 + n.row * (high + gapY);
  const byId = new Map(graph.nodes.map((n) => [n.id, n]));
  const clip = (text: string, most: number) => (text.length > most ? `${text.slice(0, most - 1)}…` : text);
  const drawing = svg(
    'svg',
    { viewBox: `0 0 ${width} ${height}`, width, height, class: 'shop-graph', role: 'group', 'aria-label': t('scenario.graph') },
    svg('defs', {}, svg('marker', { id: 'tip', viewBox: '0 0 8 8', refX: 7, refY: 4, markerWidth: 8, markerHeight: 8, orient: 'auto' }, svg('path', { d: 'M0 0 L8 4 L0 8 z', class: 'tip' }))),
    graph.edges.map((e) => {
      const a = byId.get(e.from);
      const b = byId.get(e.to);
      if (!a || !b) return null;
      const [x1, y1, x2, y2] = [x(a) + wide, y(a) + high / 2, x(b), y(b) + high / 2];
      const bend = Math.max(24, Math.abs(x2 - x1) / 2);
      return svg('path', { class: e.back ? 'edge back' : 'edge', d: `M${x1} ${y1} C${x1 + bend} ${y1} ${x2 - bend} ${y2} ${x2} ${y2}`, 'marker-end': 'url(#tip)', 'stroke-width': Math.min(4, 1 + e.parts.length / 2) }, svg('title', {}, e.parts.join(', ')));
    }),
    graph.nodes.map((n) => {
      const words = n.kind === 'source' ? t('scenario.blanks') : n.label || t('scenario.finished');
      const box = svg(
        'g',
        { class: `node ${n.kind}`, transform: `translate(${x(n)} ${y(n)})`, tabindex: 0, role: 'button', 'aria-label': `${words} ${n.below}` },
        svg('rect', { width: wide, height: high, rx: n.kind === 'machine' ? 5 : 20 }),
        svg('text', { x: wide / 2, y: n.below ? 19 : 28, 'text-anchor': 'middle' }, clip(words, 20)),
        n.below ? svg('text', { x: wide / 2, y: 36, 'text-anchor': 'middle', class: 'below' }, clip(n.below, 24)) : null,
        svg('title', {}, words),
      );
      box.addEventListener('click', () => open(n.pointer));
      box.addEventListener('keydown', (event) => {
        if ((event as KeyboardEvent).key === 'Enter' || (event as KeyboardEvent).key === ' ') {
          event.preventDefault();
          open(n.pointer);
        }
      });
      return box;
    }),
  );
  return h('div', { class: 'table-wrap', tabindex: 0, role: 'region', 'aria-label': t('scenario.graph') }, drawing);
}
