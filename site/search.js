// Search in the text of all pages, also when they are opened from disk, where nothing can be fetched:
// the index is a script (search_index.js, written by search_index.py) that is loaded when somebody
// begins to search.
class Search {
  static most = 30; // results shown
  static entries = null; // of the index: {url, title, page, text, reference}
  static root = document.currentScript.src.replace(/[^/]*$/, '');

  static init() {
    window.addEventListener('DOMContentLoaded', () => {
      const box = document.getElementById('search_words');
      box.addEventListener('focus', () => Search.show());
      box.addEventListener('input', () => Search.show());
      document.addEventListener('keydown', (event) => Search.key(event, box));
      document.addEventListener('click', (event) => {
        if (!event.target.closest('#search_results, #find')) Search.close();
      });
    });
  }

  // Loads the index once.
  static fetch() {
    if (Search.asked) return;
    Search.asked = true;
    const script = document.createElement('script');
    script.src = Search.root + 'search_index.js';
    document.head.append(script);
  }

  // Called by the index itself.
  static take(rows) {
    Search.entries = rows.map(([url, title, page, text, reference]) => ({
      url, title, page, text, reference,
      low: [title.toLowerCase(), page.toLowerCase(), text.toLowerCase()],
    }));
    Search.show();
  }

  // Every word has to occur, and COLLIDE:5 is two. Names weigh more than text, chapters more than the reference.
  static find(query) {
    const words = query.toLowerCase().replace(/([^:]):(?=\d)/g, '$1 ').split(/\s+/).filter(Boolean);
    const hits = [];
    for (const entry of Search.entries) {
      let score = entry.reference ? 0 : 25;
      const all = words.every((word) => {
        const found = Search.weight(entry.low, word);
        score += found;
        return found > 0;
      });
      if (all) hits.push({ entry, score });
    }
    hits.sort((a, b) => b.score - a.score); // stable: equal scores keep the order of the pages
    return { words, hits: hits.map((hit) => hit.entry) };
  }

  static weight([title, page, text], word) {
    const name = title.replace(/^.*::|\(.*$/g, '');
    const inTitle = name === word ? 60 : name.startsWith(word) ? 20 : title.includes(word) ? 8 : 0;
    return inTitle + (page.includes(word) ? 3 : 0) + Math.min(text.split(word).length - 1, 5);
  }

  static show() {
    Search.fetch();
    const box = document.getElementById('search_words');
    const panel = document.getElementById('search_results');
    if (!Search.entries || !box.value.trim()) return Search.close();
    const { words, hits } = Search.find(box.value);
    panel.replaceChildren(...hits.slice(0, Search.most).map((entry) => Search.result(entry, words)));
    const note = document.createElement('p');
    note.textContent =
      hits.length === 0 ? 'Nothing found.' :
      hits.length > Search.most ? `${hits.length} places; the first ${Search.most} are shown.` :
      hits.length === 1 ? 'One place.' : `${hits.length} places.`;
    panel.append(note);
    const below = document.getElementById('find').getBoundingClientRect().bottom + 4;
    panel.style.top = below + 'px';
    panel.style.maxHeight = `calc(100vh - ${below + 12}px)`;
    panel.hidden = false;
    panel.scrollTop = 0;
  }

  static result(entry, words) {
    const link = document.createElement('a');
    link.href = Search.root + entry.url;
    link.addEventListener('click', () => Search.close());
    const title = document.createElement('b');
    title.textContent = entry.title;
    const where = document.createElement('small');
    where.textContent = entry.page === entry.title ? '' : '  ' + entry.page;
    const text = document.createElement('div');
    Search.mark(text, Search.excerpt(entry, words), words);
    link.append(title, where, text);
    return link;
  }

  // The text around the first word that occurs in it.
  static excerpt(entry, words) {
    const places = words.map((word) => entry.low[2].indexOf(word)).filter((at) => at >= 0);
    const at = places.length ? Math.min(...places) : 0;
    let from = Math.max(0, at - 60);
    if (from > 0) from = entry.text.indexOf(' ', from) + 1;
    const upto = Math.min(entry.text.length, Math.max(at, from) + 110);
    return (from > 0 ? '… ' : '') + entry.text.slice(from, upto) + (upto < entry.text.length ? ' …' : '');
  }

  static mark(node, text, words) {
    const escaped = words.map((word) => word.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'));
    text.split(new RegExp(`(${escaped.join('|')})`, 'i')).forEach((part, i) => {
      if (i % 2 === 0) return node.append(part);
      const mark = document.createElement('mark');
      mark.textContent = part;
      node.append(mark);
    });
  }

  // "/" begins a search, the arrows walk through the results, Escape ends it.
  static key(event, box) {
    const links = [...document.querySelectorAll('#search_results:not([hidden]) a')];
    const at = links.indexOf(document.activeElement);
    if (event.key === '/' && !/^(INPUT|TEXTAREA|SELECT)$/.test(document.activeElement.tagName)) {
      box.focus();
    } else if (event.key === 'Escape' && links.length) {
      Search.close();
    } else if (event.key === 'ArrowDown' && (at >= 0 || document.activeElement === box) && links.length) {
      links[Math.min(at + 1, links.length - 1)].focus();
    } else if (event.key === 'ArrowUp' && at >= 0) {
      (at > 0 ? links[at - 1] : box).focus();
    } else if (event.key === 'Enter' && document.activeElement === box && links.length) {
      links[0].click();
    } else {
      return;
    }
    event.preventDefault();
  }

  static close() {
    document.getElementById('search_results').hidden = true;
  }
}
