# re-round numbers in the drafts to expected.csv, same digits
import re,csv,glob
num={}
for r in csv.reader(l for l in open('/work/main/chapters/impulse_damped/expected.csv',encoding='utf8') if not l.startswith('#')):
    if r[0]!='figure': num[(r[0],r[1])]=float(r[3])
for f in ['/work/main/chapters/impulse_damped/page.md']:
    t=open(f,encoding='utf8').read()
    def s(m):
        k=(m.group(4),m.group(5))
        if k not in num: return m.group(0)
        w=m.group(1); x=num[k]*(100 if m.group(2) else 1)
        if 'e' in w:
            mant,_,e=w.partition('e'); d=len(mant.split('.')[1]) if '.' in mant else 0
            n=re.sub(r'e([+-])0*(\d+)',lambda q:'e'+('-' if q.group(1)=='-' else '')+q.group(2),f'{x:.{d}e}')
            if n!=w and abs(float(w)-x)>0.5000001*10**(int(e)-d): print(w,'->',n,k); return n+m.group(0)[len(w):]
            return m.group(0)
        dec=len(w.split('.')[1]) if '.' in w else 0
        n=f'{x:.{dec}f}'
        if abs(float(w)-x)>0.5000001*10**-dec:
            print(f.split('/')[-1],w,'->',n,k); return n+m.group(0)[len(w):]
        return m.group(0)
    t=re.sub(r'([^\s|(]+)( per cent)?(\s?)<!--\s*(\w+):\s*([^>]*?)\s*-->',s,t)
    open(f,'w',encoding='utf8').write(t)
