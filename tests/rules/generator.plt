/* Values of the variables of a manifest. */
:- module(test_generator, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(generator)).
:- use_module(rules(limits)).

:- op(700, xfx, in).
:- op(150, xfx, ..).

values(Source, Values) :-
    values(Source, '.', Values).

values(Source, Folder, Values) :-
    catch(findall(V, generated([in(V, Source)], Folder), Values),
          generator_error(What), Values = What).

%   with_files(Files, Goal): call(Goal, Folder), which has Files, Name-Octets.

:- meta_predicate with_files(+, 1).

with_files(Files, Goal) :-
    tmp_file(generator, Folder),
    setup_call_cleanup(
        ( make_directory(Folder),
          forall(member(Name-Text, Files),
                 ( directory_file_path(Folder, Name, File),
                   setup_call_cleanup(
                       open(File, write, Out, [encoding(octet)]),
                       format(Out, "~s", [Text]),
                       close(Out)) )) ),
        call(Goal, Folder),
        delete_directory_and_contents(Folder)).

rows(File, Columns, Rows, Folder) :-
    length(Columns, N),
    length(Vs, N),
    catch(findall(Vs, generated([in(Vs, rows(File, Columns))], Folder), Rows),
          generator_error(What), Rows = What).

table(Name, Text, Columns, Rows) :-
    with_files([Name-Text], rows(Name, Columns, Rows)).

globs(Pattern, Files, Folder) :-
    values(glob(Pattern), Folder, Files).

fault(Generators, Term, Kind) :-
    (   generator_fault(Generators, Term, Fault)
    ->  functor(Fault, Kind, _)
    ;   Kind = none
    ).

:- begin_tests(generator).

test(values, [ forall(member(Source-Values,
     [ ..(1,3)-[1,2,3], ..(2,2)-[2], ..(3,2)-[], ..(-1,0)-[-1,0],
       between(1,3)-[1,2,3], between(1,2,0.5)-[1,1.5,2],
       between(0,1,0.3)-[0,0.3,0.6,0.9], between(0.1,0.4,0.1)-[0.1,0.2,0.3,0.4],
       between(5,1,1)-[], between(1,1,7)-[1], between(-2,2,2)-[-2,0,2],
       [a,3,"x"]-[a,3,"x"],
       ..(1,a)-range(..(1,a)), ..(1.0,2)-range(..(1.0,2)),
       between(1,2.5)-range(between(1,2.5)),
       between(a,2,1)-range(between(a,2,1)),
       between(1,b,1)-range(between(1,b,1)),
       between(1,2,0)-steps(0), between(1,2,-1)-steps(-1),
       between(1,2,s)-steps(s) ])),
               true(Found == Values) ]) :-
    values(Source, Found).
test(few, [ cleanup(set_limit(values, 10 000 000)),
            true(Found == [3,limit(values,4,3),3,limit(values,4,3)]) ]) :-
    set_limit(values, 3),
    findall(What,
            ( member(Source, [ ..(1,3), ..(1,4), between(0,1,0.5),
                               between(0,1.5,0.5) ]),
              values(Source, Values),
              ( is_list(Values) -> length(Values, What) ; What = Values ) ),
            Found).
test(in_order, Pairs == [1-a,1-b,2-a,2-b]) :-
    findall(A-B, generated([in(A, ..(1,2)),in(B, [a,b])], '.'), Pairs).
test(of_those_before, Pairs == [1-1,2-1,2-2]) :-
    findall(A-B, generated([in(A, ..(1,2)),in(B, ..(1,A))], '.'), Pairs).
test(conjuncts, Lengths == [1,2,3,1]) :-
    findall(N, ( member(Goal, [a,(a,b),((a,b),c),_]), conjuncts(Goal, Goals),
                 length(Goals, N) ), Lengths).
test(faults, [ forall(member(Generators-Term-Kind,
     [ [in(V,..(1,2))]-f(V)-none, []-f(a)-none, []-f(V)-unbound,
       [in(V,..(1,2))]-f(_)-unbound,
       [in(V,..(1,2)),in(V,..(1,2))]-f(V)-bound_twice,
       [in(V,..(1,W)),in(W,..(1,2))]-f(V)-unbound,
       [in(W,..(1,2)),in(V,..(1,W))]-f(V)-none,
       [in(a,..(1,2))]-f-generator, [foo]-f-generator, [_]-f-generator,
       [in(V,_)]-f(V)-generator, [in(V,foo)]-f(V)-generator,
       [in(V,..(a,2))]-f(V)-generator, [in(V,..(1,b))]-f(V)-generator,
       [in(V,between(1,2))]-f(V)-none, [in(V,between(a,2))]-f(V)-generator,
       [in(V,between(1,b))]-f(V)-generator,
       [in(V,between(1,2,0.5))]-f(V)-none,
       [in(V,between(a,2,3))]-f(V)-generator,
       [in(V,between(1,b,3))]-f(V)-generator,
       [in(V,between(1,2,c))]-f(V)-generator,
       [in(V,[])]-f(V)-generator, [in(V,[a,1,2.5,"x"])]-f(V)-none,
       [in(V,[f(x)])]-f(V)-generator, [in(V,[a|b])]-f(V)-generator,
       [in(V,glob('*'))]-f(V)-none, [in(V,glob("*"))]-f(V)-none,
       [in(V,glob(3))]-f(V)-generator,
       [in([V,W],rows(f,[a,"b"]))]-f(V,W)-none,
       [in([V],rows(f,[a,b]))]-f(V)-generator,
       [in([V,V],rows(f,[a,b]))]-f(V)-generator,
       [in([V,x],rows(f,[a,b]))]-f(V)-generator,
       [in(V,rows(f,[a]))]-f(V)-generator,
       [in([V],rows(3,[a]))]-f(V)-generator,
       [in([V],rows(f,[3]))]-f(V)-generator,
       [in([V],rows(f,a))]-f(V)-generator ])),
               true(Found == Kind) ]) :-
    fault(Generators, Term, Found).

test(rows, [ forall(member(Name-Text-Columns-Rows,
     [ 'a.csv'-"r,h\n1,2.5\nx, y z \n"-[r,h]-[[1,2.5],[x,'y z']],
       'a.csv'-"r,h\n1,2\n"-[h]-[[2]],
       'a.csv'-"r,h\n1,2\n"-["h",r]-[[2,1]],
       'a.csv'-"r,h\n\n1,2\n\n"-[r]-[[1]],
       'a.csv'-"r\n"-[r]-[],
       'a.csv'-"1,2\n3,4\n"-['1']-[[3]],
       'a.tsv'-"r\th\n1\t2,5\n"-[h]-[['2,5']],
       'a.csv'-"r;h\n1;2,5\n"-[h]-[[2.5]],
       'a.csv'-"r;h\n1;a,b\n"-[h]-[['a,b']],
       'a.csv'-"r;h\n1;2,5,1\n"-[h]-[['2,5,1']],
       'a.csv'-"r,h;i\n1,2\n"-['h;i']-[[2]],
       'a.csv'-"r,h\n\"a,b\",2\n"-[r]-[['a,b']],
       'a.csv'-[0xef,0xbb,0xbf,0'r,0'\n,0'7,0'\n]-[r]-[[7]],
       'a.csv'-""-[r]-rows('a.csv',1,no_table),
       'a.csv'-"r,h\n"-[x]-rows('a.csv',1,no_column(x,[r,h])),
       'a.csv'-"r,h\n1\n"-[r]-rows('a.csv',2,width(1,2)),
       'a.csv'-"r,h\n1,2\n1,2,3\n"-[r]-rows('a.csv',3,width(3,2)),
       'a.csv'-"r,h\n\"1,2\n"-[r]-rows('a.csv',2,no_table),
       'a.csv'-[0'r,0'\n,0xff,0'\n]-[r]-rows('a.csv',2,not_utf8) ])),
             true(Found == Rows) ]) :-
    table(Name, Text, Columns, Found).
test(no_table, Rows == rows('b.csv', 0, missing)) :-
    with_files([], rows('b.csv', [r], Rows)).
test(absolute, Rows == [[1]]) :-
    with_files(['a.csv'-"r\n1\n"], absolute_rows(Rows)).

test(glob, [ forall(member(Pattern-Files,
     [ '*.pl'-['a.pl','b.pl'], 'a.*'-['a.csv','a.pl'], 'b.pl'-['b.pl'],
       "?.csv"-['a.csv'], '*.obj'-glob('*.obj'), 'c.pl'-glob('c.pl') ])),
             true(Found == Files) ]) :-
    with_files(['b.pl'-"",'a.pl'-"",'a.csv'-""], globs(Pattern, Found)).
test(stays_there) :-
    working_directory(Here, Here),
    with_files(['b.pl'-""], globs('*', ['b.pl'])),
    working_directory(After, After),
    Here == After.

:- end_tests(generator).

absolute_rows(Rows, Folder) :-
    directory_file_path(Folder, 'a.csv', File),
    rows(File, [r], Rows, '/').
