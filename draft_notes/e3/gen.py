import csv,re,os
D='/tmp/e3/out/'
figs=['fig5_2_friction','claim_5_3c_friction','claim_5_3f_chain','claim_5_3g_seen','fig6_6_projectile','fig6_6_projectile_curves','fig6_7_clump','crate_off_table']
V={}
rows={}
for f in figs:
    rs=list(csv.reader(l for l in open(D+f+'_numbers.csv') if not l.startswith('#')))
    h=rs[0]; rows[f]=[dict(zip(h,r)) for r in rs[1:]]
    for r in rows[f]: V[f,r['quantity']]=float(r['value'])
t=open('/tmp/e3/page.src').read()
def sub(m):
    f,q,d=m.group(1).rsplit('|',2)
    return f"{V[f,q]:.{int(d)}f} <!-- {f}: {q} -->"
t=re.sub(r'\{([a-z0-9_]+\|[^}]*)\}',sub,t)
open('/tmp/e3/page.md.part','w').write('<!-- goes into the results of chapters/impulse_damped/page.md -->\n'+t)
exact={('fig5_2_friction','common speed if momentum is kept'):('0.666666666667',1e-11,'m v/(m + M) = 2/3, twelve digits'),
 ('fig6_6_projectile','boxes of the pyramid'):(None,0,'1 + 2 + ... + 10'),
 ('fig6_7_clump','cubes'):(None,0,'5³')}
out=['# goes into chapters/impulse_damped/expected.csv (figure,quantity,unit,value,tolerance,reason)']
for f in figs:
    for r in rows[f]:
        v=float(r['value']); q=r['quantity']
        whole=v==int(v) and (abs(v)<1000)
        if (f,q) in exact: tol,why=exact[f,q][1:]
        elif v==0: tol,why='0','measured; exactly none'
        elif whole and r['unit']=='-' and v>=1: tol,why='0','measured; a count, the same on all machines'
        else: tol,why='%.1g'%(abs(v)*1e-6),'measured; bits are the same on all machines, digits as written'
        val=exact[f,q][0] if (f,q) in exact and exact[f,q][0] else '%.8g'%v
        out.append(f'{f},"{q}",{r["unit"]},{val},{tol},"{why}"')
open('/tmp/e3/expected.csv.part','w').write('\n'.join(out)+'\n')
