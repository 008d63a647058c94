// A chart in a page: drawn when the page is shown, redrawn when light turns to dark, thrown away when it is left.
// Charts are pure functions from data and theme to an ECharts option; the page holds the same numbers as a table.

import { h } from '../dom';
import type { Cell } from '../logic/csv';
import { fileName } from '../logic/csv';
import { saveMenu, tableItems, type SaveItem } from '../ui/save';
import type { PageContext } from '../page';
import type { AnyOption } from './echarts';
import { currentTheme, type Theme } from './theme';

export interface Chart {
  element: HTMLElement;
  redraw: () => void;
}

export interface ChartExtras {
  /** Name of the files it is saved to; default the label's beginning. */
  name?: string;
  /** Head row and rows of the numbers behind the picture. */
  data?: () => Cell[][];
  /** A click on a point: its series' name and the data item. */
  onClick?: (item: { seriesName: string; dataIndex: number; data: unknown }) => void;
}

/**
 * @param label what a screen reader says in place of the picture
 * @param heightClass CSS class that gives the height
 */
export function chart(context: PageContext, label: string, heightClass: string, option: (theme: Theme) => AnyOption, extras: ChartExtras = {}): Chart {
  const element = h('div', { class: `chart ${heightClass}`, role: 'img', 'aria-label': label });
  const name = extras.name ?? label.slice(0, 60);
  const full = (theme: Theme): AnyOption => ({ animation: false, textStyle: { fontFamily: theme.font, color: theme.text }, ...option(theme) });
  let redraw = () => {};
  let png: (() => string) | undefined;
  let left = false;
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const onTheme = () => redraw();
  context.whenShown(() => {
    void import('./echarts').then(({ init }) => {
      if (left) return;
      const instance = init(element, null, { renderer: 'canvas' });
      redraw = () => {
        const theme = currentTheme();
        instance.setOption(full(theme), true);
        element.dataset['drawn'] = 'yes';
      };
      redraw();
      png = () => instance.getDataURL({ type: 'png', pixelRatio: 2, backgroundColor: currentTheme().panel });
      if (extras.onClick) instance.on('click', (p) => extras.onClick?.({ seriesName: p.seriesName ?? '', dataIndex: p.dataIndex, data: p.data }));
      const observer = new ResizeObserver(() => instance.resize());
      observer.observe(element);
      dark.addEventListener('change', onTheme);
      context.whenLeft(() => {
        observer.disconnect();
        dark.removeEventListener('change', onTheme);
        instance.dispose();
      });
    });
  });
  context.whenLeft(() => {
    left = true;
  });
  const file = fileName(name);
  const items: SaveItem[] = [
    {
      label: 'PNG',
      file: `${file}.png`,
      content: () => {
        const [, base64 = ''] = (png?.() ?? '').split(',');
        return new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], { type: 'image/png' });
      },
    },
    {
      label: 'SVG',
      file: `${file}.svg`,
      content: async () => {
        const { svgText } = await import('./svg');
        return new Blob([svgText(full(currentTheme()), element.clientWidth, element.clientHeight, currentTheme().panel)], { type: 'image/svg+xml' });
      },
    },
    ...(extras.data ? tableItems(name, extras.data) : []),
  ];
  return { element: h('div', { class: 'with-save' }, element, saveMenu(name, items)), redraw: () => redraw() };
}

/** Tooltips are drawn on the canvas: the content security policy leaves no room for HTML ones. */
export function tooltip(theme: Theme): { renderMode: 'richText'; backgroundColor: string; borderColor: string; textStyle: { color: string; fontSize: number }; confine: boolean } {
  return { renderMode: 'richText', backgroundColor: theme.panel, borderColor: theme.line, textStyle: { color: theme.text, fontSize: 12 }, confine: true };
}
