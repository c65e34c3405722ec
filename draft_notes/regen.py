import glob,os,re
os.chdir('/work/main')
p='chapters/CMakeLists.txt'; s=open(p).read()
files=sorted('impulse_damped/'+os.path.basename(f) for f in glob.glob('chapters/impulse_damped/*.cpp') if not f.endswith('reproduce.cpp'))
block='tumble_chapter(impulse_damped\n'
line=' '
for f in files:
    if len(line)+1+len(f)>98: block+=line+'\n'; line=' '
    line+=' '+f
block+=line+')\n'
if 'tumble_chapter(impulse_damped' in s:
    s=re.sub(r'tumble_chapter\(impulse_damped\n.*?\)\n',lambda m:block,s,flags=re.S)
else:
    s=s.replace('list(APPEND finding_files ${CMAKE_CURRENT_SOURCE_DIR}/open_claims.toml)',block+'\nlist(APPEND finding_files ${CMAKE_CURRENT_SOURCE_DIR}/open_claims.toml)')
open(p,'w').write(s)
