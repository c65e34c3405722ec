import re,csv,glob,os
M='/work/main/'
page=open(M+'chapters/impulse_damped/page.md',encoding='utf8').read()
num={}
for r in csv.reader(l for l in open(M+'chapters/impulse_damped/expected.csv',encoding='utf8') if not l.startswith('#')):
    if r[0]!='figure': num[(r[0],r[1])]=float(r[3])
n=0
for m in re.finditer(r'([^\s|(]+)( per cent)?\s?<!--\s*(\w+):\s*([^>]*?)\s*-->',page):
    w=m.group(1)
    try: v=float(w)
    except ValueError: print('NaN',w,m.group(4)); continue
    k=(m.group(3),m.group(4))
    if k not in num: print('unknown',k); continue
    x=num[k]*(100 if m.group(2) else 1)
    mant,_,e=w.partition('e'); dec=len(mant.split('.')[1]) if '.' in mant else 0
    if abs(x-v)>0.5000001*10**((int(e) if e else 0)-dec): print('STALE',w,x,k)
    n+=1
print(n,'numbers;', page.count('<!--'),'comments')
for f,mk in re.findall(r'\\snippet\{lineno\} (\S+) (.*)',page):
    t=open(M+'src/'+f,encoding='utf8').read()
    if t.count('['+mk.strip()+']')!=2: print('mark',f,mk,t.count('['+mk.strip()+']'))
for f in re.findall(r'\\image html (\w+)\.svg',page):
    if not os.path.exists(M+f'figures/impulse_damped/{f}.gp'): print('no script',f)
have={os.path.basename(g)[:-3] for g in glob.glob(M+'figures/impulse_damped/*.gp')}
print('figures not shown:',sorted(have-set(re.findall(r'\\image html (\w+)\.svg',page))))
tests=''.join(open(f,encoding='utf8').read() for d in('impulse_damped','geometric_stability') for f in glob.glob(M+f'verification/{d}/*.cpp'))
tests=re.sub(r'"\s*\n\s*"','',tests)
v=page[page.index('## Verified by'):page.index('## Try it')]
for s in re.findall(r'(?m)^- "(.*)"$',v):
    if f'TEST_CASE("{s}"' not in tests and not re.search(r'TEST_CASE\(\s*"'+re.escape(s)+'"',tests): print('no test:',s)
import re as _
for b in re.findall(r'`[^`]*`',page):
    if "'" in b: print("quote in backticks",b)
for i,l in enumerate(page.split('\n'),1):
    if len(l)>160 and '<!--' not in l and not l.startswith('\\image') and not l.startswith('|'): print('long',i,len(l))
    if l.rstrip()!=l: print('blank end',i)
print('TODO:',re.findall(r'<!-- TODO (\S+)',page))
import tomllib
flat=re.sub(r'\s+',' ',page)
for c in tomllib.load(open(M+'chapters/impulse_damped/claims.toml','rb'))['claim']:
    v=num[(c['figure'],c['quantity'])]
    if not c.get('comparable',True): verdict='not comparable'
    else:
        t=lambda r: eval(f'{v!r} {r}')
        verdict='confirmed' if t(c['confirmed']) else 'refuted' if t(c['refuted']) else 'qualified'
    m=re.search(re.escape(f'"{c["id"]}"')+r'[^*]{0,160}?\*\*(\w+( \w+)?)\*\*',flat[flat.index('## What you should see'):])
    said=m.group(1) if m else None
    print(c['id'],v,verdict,'' if said==verdict else f'<<< page says {said}')
