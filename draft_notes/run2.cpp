#include "tumble/impulse_damped/contact_damped.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/base/random.hpp"
#include "tumble/math/rotation.hpp"
#include <chrono>
#include <cstdio>
#include <cstring>
#include <cstdlib>
#include <algorithm>
using namespace tumble;
int main(int c,char**v){
  std::string name=v[1]; double secs=atof(v[2]); ContactDampedOptions o; double jit=0; Parameters p=scene_recipe(name).parameters();
  bool verbose=false; double dt_=1.0/60; int direct_rounds=60;
  for(int i=3;i<c;++i){std::string s=v[i]; auto e=s.find('='); auto k=s.substr(0,e),x=s.substr(e+1);
    if(k=="passes")o.passes=atoi(x.c_str()); else if(k=="rounds")o.rounds=atoi(x.c_str()); else if(k=="rp")o.repair_passes=atoi(x.c_str()); else if(k=="sleep")o.sleeping=true;  else if(k=="rounds")o.rounds=atoi(x.c_str());  else if(k=="jit")jit=atof(x.c_str()); else if(k=="v")verbose=true;   else if(k=="hz")dt_=1.0/atof(x.c_str());    else p.set(k,x);}
  Scene sc=scene_recipe(name).build(p,Random(1));
World w=build_world(sc);
  if(jit>0)for(int i=0;i<w.count();++i)if(w.bodies()[i].movable()){Random r=Random(7).fork((unsigned)i);auto&b=w.states()[i];b.position_w+=r.in_cube(jit*1e-3);b.orientation_wb=rotation_from_degrees(r.in_cube(0.2*jit))*b.orientation_wb;} ContactDamped t(o); std::vector<BodyState> ref; std::vector<double> ms; std::vector<BodyState> start(w.states().begin(),w.states().end());
  int steps=int(secs/dt_+.5); long it=0; double rep=0,unb=0,booked=0; auto total=[](const World&w){double e=0;for(int i=0;i<w.count();++i)if(w.bodies()[i].movable())e+=kinetic_energy(w.bodies()[i],w.states()[i])-w.bodies()[i].mass*w.gravity_w.dot(w.states()[i].position_w);return e;}; double e0=total(w); double worst2=0;
  for(int s=0;s<steps;++s){ {int nb=w.count(); if(s>0)add_late_boxes(sc,w.time()-dt_,w.time(),w); if(w.count()!=nb)e0=total(w)-booked;}
  
    auto a=std::chrono::steady_clock::now(); StepReport r=t.step(w,dt_); double d=std::chrono::duration<double>(std::chrono::steady_clock::now()-a).count()*1e3; ms.push_back(d); it+=r.iterations; rep+=r.energy.repair; {double e=total(w)-e0-(booked+=r.energy.total()); unb=std::max(unb,std::abs(e));}
    if(verbose&&(s<20||s%(1+(steps>400?29:0))==0)){double vm=0;for(int i=0;i<w.count();++i)vm=std::max(vm,velocity(w.bodies()[i],w.states()[i]).norm());printf("%4d it %3ld F %ld fb %ld vmax %9.2e deep %9.2e contacts %ld ms %.3f\n",s,(long)r.iterations,(long)r.pivots,(long)r.fallbacks,vm,r.deepest_overlap,(long)r.contacts,d);}
    
    if(s==int(2/dt_)-1)ref.assign(w.states().begin(),w.states().end());
    if(s>=int(2/dt_))for(size_t i=0;i<ref.size();++i)worst2=std::max(worst2,(w.states()[i].position_w-ref[i].position_w).norm());
  }
  double drift=0,sag=0,vr=0;for(size_t i=0;i<start.size();++i){drift=std::max(drift,(w.states()[i].position_w-start[i].position_w).norm());sag=std::max(sag,start[i].position_w.y()-w.states()[i].position_w.y());vr=std::max(vr,velocity(w.bodies()[i],w.states()[i]).norm());}
  double tot=0;for(double d:ms)tot+=d; std::sort(ms.begin(),ms.end());
  printf("%s: boxes %zu drift %.3e sag %.3e moved after 2s %.3e vmax %.2e | median %.4f p99 %.3f mean %.4f ms it/step %.1f unb %.2e rep %.2e\n",name.c_str(),sc.boxes.size(),drift,sag,worst2,vr,ms[ms.size()/2],ms[ms.size()*99/100],tot/ms.size(),double(it)/steps,unb,rep);
}
