// The gallery of scenarios, studies and operations, built into the program as files of the pages.

import type { Json } from './logic/pointer';

const urls = import.meta.glob<string>('../../../scenarios/gallery/**/*.json', { query: '?url', import: 'default', eager: true });

export interface GalleryItem {
  /** "heavy-lathe", "turning" */
  name: string;
  kind: 'scenario' | 'study' | 'operation';
  url: string;
}

export const gallery: readonly GalleryItem[] = Object.entries(urls)
  .map(([path, url]): GalleryItem => {
    const file = path.slice(path.lastIndexOf('/') + 1).replace(/\.json$/, '');
    const kind = path.includes('/operations/') ? 'operation' : file.endsWith('.study') ? 'study' : 'scenario';
    return { name: file.replace(/\.study$/, ''), kind, url };
  })
  .sort((a, b) => a.name.localeCompare(b.name));

/** The text of a gallery file. */
export async function galleryText(item: GalleryItem, signal?: AbortSignal): Promise<string> {
  const response = await fetch(item.url, signal ? { signal } : {});
  if (!response.ok) throw new Error(`${item.name}: HTTP ${response.status}`);
  return response.text();
}

export async function galleryJson(item: GalleryItem, signal?: AbortSignal): Promise<Json> {
  return JSON.parse(await galleryText(item, signal)) as Json;
}
