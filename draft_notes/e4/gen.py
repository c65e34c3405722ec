import csv, math, sys
out=(sys.argv[1] if len(sys.argv)>1 else '/tmp/e4/out')+'/'
figs=['claim_2_4_2a_tosses','claim_3_1a_faces','claim_4_5a_sleeping','claim_6_1a_frame_rate','claim_6_3_1a_size']
N={}; rows={}
for f in figs:
    rows[f]=[r for r in csv.reader(l for l in open(out+f+'_numbers.csv') if not l.startswith('#'))][1:]
    for r in rows[f]: N[f,r[0]]=float(r[2])
q={'t':figs[0],'f':figs[1],'s':figs[2],'r':figs[3],'z':figs[4]}
def num(k,name,fmt,pc=False,sgn=1):
    v=N[q[k],name]*(100 if pc else 1)
    t=fmt%v
    return t+(' per cent' if pc else '')+' <!-- %s: %s -->'%(q[k],name)
D={'t':'distance of travel and time to rest from the measured quartiles, with randomness over without',
'f':'share of the boxes of settled clumps that rest with a face down, within a degree',
's':'pair tests, impulses and integrations of a step with a tenth of the boxes moving, over those with all of them moving',
'r':'pairs that were tested for contact in a step of the clump of figure 6.7, on average',
'z':'largest difference of the dimensionless motion between boxes of 0.01, 1 and 100 times the size, in edges'}
v={k:N[q[k],D[k]] for k in D}
verdict={'t':'confirmed' if v['t']<=.9 else 'refuted' if v['t']>=1 else 'qualified',
'f':'confirmed' if v['f']>=.8 else 'refuted' if v['f']<.5 else 'qualified',
's':'confirmed' if v['s']<=.15 else 'refuted' if v['s']>.5 else 'qualified',
'z':'confirmed' if v['z']<=1e-6 else 'refuted' if v['z']>.01 else 'qualified'}
spread=", over their spread, "
P={}
P['2_4_2a']=f'''\\image html claim_2_4_2a_tosses.svg "Tossed cubes by travel and by time to rest: damped with chance and without, impulses alone, contact_damped; dots are quartiles of measured tosses"

Twenty real cubes (Pfrommer, Halm, Posa: ContactNets, CoRL 2020) tell what is plausible. With chance in fast collisions travel and time to rest are
{num('t',D['t'],'%.2f')} times as far from their quartiles as without: claim \\ref claim_2_4_2a "2.4.2a" is **{verdict['t']}**. Travel comes nearer,
{num('t','the same, travel only','%.2f')} times, time to rest stays ({num('t','the same, time to rest only','%.2f')}), and with twice the thresholds the ratio is
{num('t','the same, twice the epsilons','%.2f')}; 800 tosses do not tell it from 1. Chance changes who goes where, hardly how far all of them go. The law of contact matters more: in
spreads of the measured tosses the time is off by {num('t','distance of time to rest from the measured quartiles'+spread+'damped, no chance','%.1f')} damped,
{num('t','distance of time to rest from the measured quartiles'+spread+'impulses alone','%.1f')} with impulses alone and
{num('t','distance of time to rest from the measured quartiles'+spread+'contact_damped','%.1f')} with `contact_damped`, which also slides farther
({num('t','distance of travel from the measured quartiles'+spread+'contact_damped','%.1f')}). A frame is a third of a spread.
'''
P['3_1a']=f'''\\image html claim_3_1a_faces.svg "Share of settled boxes against the tilt of the face that is nearest to level"

Of the boxes of sixty settled clumps {num('f',D['f'],'%.0f',True)} lie with a face level within a degree: claim \\ref claim_3_1a "3.1a" is **{verdict['f']}**. In clumps
of 8 it is {num('f','the same, 8 boxes','%.0f',True)}, of 27 {num('f','the same, 27 boxes','%.0f',True)}, of 64 {num('f','the same, 64 boxes','%.0f',True)}: in a
higher heap more boxes lean on neighbours, and friction holds them there. The curve is flat from a hundredth of a degree to a degree; what is down is
down. The thesis's damping, which has no friction, gets to {num('f','the same, damped as in the thesis','%.0f',True)}: what leans slides off, and only
{num('f','share of the boxes that rest in the end, damped as in the thesis','%.0f',True)} of its boxes rest by then, against
{num('f','share of the boxes that rest in the end','%.0f',True)} here.
'''
P['4_5a']=f'''\\image html claim_4_5a_sleeping.svg "Work of a step against the share of boxes that move, with sleeping and without; boxes awake after one was taken away"

A step in which a tenth of 100 boxes moves takes {num('s',D['s'],'%.2f')} of the pair tests, impulses and integrations of one in which all move, and
{num('s','work of a step with nothing moving','%.0f')} if none does; without sleeping the ratio is {num('s','the same, nothing sleeps','%.2f')}. Claim
\\ref claim_4_5a "4.5a" is **{verdict['s']}**, for stacks that do not touch. Heaps wake as a whole: of a pyramid of
{num('s','pyramid, top box pushed: boxes','%.0f')} boxes whose top box is pushed {num('s','pyramid, top box pushed: boxes that wake','%.0f')} wake, and
{num('s','pyramid, top box pushed: boxes that move','%.0f')} moves. Bounds of sleepers are still looked through, which is not counted. If the lowest of five boxes is removed, all
{num('s','lowest box taken away: boxes that wake','%.0f')} above it wake in step {num('s','lowest box taken away: steps until the last one wakes','%.0f')}, the
stack beside it sleeps on, and after {num('s','lowest box taken away: steps until all sleep again','%.0f')} steps everybody does.
'''
P['6_1a']=f'''\\image html claim_6_1a_frame_rate.svg "Pairs tested and impulses in a step against the number of boxes, for the clump and for a pyramid"

25 frames a second on a machine of 1500 MHz say nothing about ours, and how many boxes the thesis had is not told: claim \\ref claim_6_1a "6.1a" is **not
comparable**. What can be counted is work. In the clump of {num('r','cubes of the clump','%.0f')} cubes damped integration tests
{num('r',D['r'],'%.0f')} pairs in a step, each again in every pass, and gives {num('r','impulses in a step of the clump, on average','%.0f')} impulses;
`contact_damped` tests {num('r','pairs tested in a step of the clump, on average, contact_damped','%.0f')} and gives
{num('r','impulses in a step of the clump, on average, contact_damped','%.0f')}. There are {num('r','pairs in all, the ground included','%.0f')} pairs. A
pyramid of {num('r','boxes of the pyramid','%.0f')} boxes at rest costs {num('r','pairs tested in a step of the pyramid, on average','%.0f')} tests and
{num('r','impulses in a step of the pyramid, on average','%.1f')} impulses damped. Damped, tests and impulses of the clump grow about as its number of cubes. Times are what `make bench` is for.
'''
zf='%.2g'
big=v['z']>1e-6
P['6_3_1a']=f'''\\image html claim_6_3_1a_size.svg "The way of a sliding box at three sizes, damped by contact and as in the thesis, beside Coulomb; below, how far motions of three scenes are apart"

`contact_damped` has no size of its own. At 1/64 and 64 times the size, where nothing is rounded, no bit differs
({num('z','the same, 1/64, 1 and 64 times the size, where nothing is rounded','%.0f')}). At 0.01 and 100 motions differ by up to
%s of an edge: claim \\ref claim_6_3_1a "6.3.1a" is **{verdict['z']}**. %s The mass is as free (%s). The thesis's damping is a factor for a time, and
carries its boxes {num('z','the same, damped as in the thesis','%.0f')} edges apart. A box stops {num('z','stopping distance','%.3f')} m from where it was, by Coulomb's law it is
{num('z','stopping distance of Coulomb','%.3f')}: an error of
{num('z',"its error, over Coulomb's",'%.1f',True)}, which is half a step at full speed, and of {num('z','its error with steps of 1/960 s','%.1f',True)} with
steps of 1/960 s. Damped it is {num('z','error of the stopping distance, damped as in the thesis','%.0f',True)}.
'''
def small(name):
    x=N[q['z'],name]
    if x<1e-3:  # written in millionths or as 0
        return '0.'+('%.7f'%x)[2:]+' <!-- %s: %s -->'%(q['z'],name)
    return num('z',name,zf)
P['6_3_1a']=P['6_3_1a']%(small(D['z']),
 'It is the stack: while it slides the direct solver reaches its last round unsettled, and where it stands then hangs on rounding. A box that slides alone is within rounding.' if big else 'That is rounding, grown by impacts.',
 small('the same, densities of 0.001, 1 and 1000'))
with open('/tmp/e4/page.md.part','w') as o:
    o.write('Goes into chapters/impulse_damped/page.md, each in place of its <!-- TODO claim_... --> line.\n')
    for k,t in P.items():
        import re
        words=len(re.sub(r'<!--.*?-->','',t.split('\n',2)[2]).split())
        t=re.sub(r' (<!-- [^>]*-->)(?=[,.;:)])',r'\1',t); t=re.sub(r'--> (?=\w|`)','-->',t)
        o.write('\n<!-- TODO claim_%s --> (%d words)\n\n'%(k,words)+t)
T={'t':("damped","as_meant","Chance changes tosses, and brings travel and time to rest hardly nearer to measured ones"),
'f':("contact_damped","ours","Most boxes of a settled clump have a face down"),
's':("contact_damped, sleeping=on","ours","A step costs what moves, and a box that loses its support wakes its heap at once"),
'r':("damped","as_meant","More boxes in a clump mean more pairs to test, and fewer than all"),
'z':("contact_damped","ours","The motion of boxes is the same to the bit at 64 times their size, and alike at 0.01 and 100")}
import subprocess
src=subprocess.run(['git','-C','/work/main','show','7450b21:chapters/open_claims.toml'],capture_output=True,text=True).stdout
blocks={}
for b in src.split('[[claim]]')[1:]:
    d=dict(l.split(' = ',1) for l in b.strip().splitlines() if ' = ' in l); blocks[d['id'].strip('"')]=d
o=open('/tmp/e4/claims.toml.part','w'); o.write('# Goes into chapters/impulse_damped/claims.toml; the same five leave chapters/open_claims.toml.\n')
for k,i in zip('tfsrz',['2.4.2a','3.1a','4.5a','6.1a','6.3.1a']):
    d=blocks[i]; tech,read,test=T[k]
    o.write('\n[[claim]]\n')
    for key in ('id','section','statement','experiment'): o.write('%s = %s\n'%(key,d[key]))
    o.write('technique = "%s"\nreading = "%s"\n'%(tech,read))
    if k=='r':
        o.write('quantity = "%s"\nunit = "-"\ncomparable = false\n'%D['r'])
        o.write('reason = "The thesis tells no number of boxes, and frames a second are of its machine: what can be repeated is the count of the work. The clock is for make bench."\n')
    else:
        for key in ('quantity','unit','confirmed','refuted','reason'): o.write('%s = %s\n'%(key,d[key]))
    o.write('figure = "%s"\ntest = "%s"\n'%(q[k],test))
closed={'stopping distance of Coulomb':'closed form: v²/(2 mu g)','pairs in all, the ground included':'125 * 126 / 2','cubes of the clump':'5³','boxes of the pyramid':'10 * 11 / 2','pyramid, top box pushed: boxes':'10 * 11 / 2',
'the same, 1/64, 1 and 64 times the size, where nothing is rounded':'powers of four scale exactly'}
e=open('/tmp/e4/expected.csv.part','w'); e.write('# Goes at the end of chapters/impulse_damped/expected.csv.\n')
for f in figs:
    for r in rows[f]:
        x=float(r[2]); integer=abs(x-round(x))<1e-9 and f!=figs[0]
        if x!=0 and abs(x)<1e-11: val,tol,why='0','1e-11','measured %.1e; rounding'%x
        elif integer: val,tol,why='%d'%round(x),('0' if x==round(x) else '1e-12'),'measured; a count'
        else:
            val='%.10g'%x; ex=math.floor(math.log10(abs(x))); tol='%.0e'%(10.0**(ex-9)); why='measured; bits are the same on all machines, digits as written'
        if r[0]==D['s']: why='measured; a tenth moves, and no stack touches another'
        if r[0] in closed: why=closed[r[0]]
        e.write('%s,"%s",%s,%s,%s,"%s"\n'%(f,r[0],r[1],val,tol,why))
        assert abs(float(val)-x)<=float(tol),(r,val,tol)
