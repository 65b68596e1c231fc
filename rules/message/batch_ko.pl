:- encoding(utf8).
:- module(sg_batch_ko,
          [ manifest_ko//1,             % +What
            batch_ko//1,                % +What
            batch_usage_ko//1           % +What
          ]).
:- use_module(message_parts, [meant_ko//1]).
:- use_module(library(lists), [member/2]).
/** <module> Batches: what is wrong with a manifest, what became of jobs, in
Korean.

The heads are those of batch_en.pl.
*/

%!  manifest_ko(+What)// is det.
%
%   The message for model_error(manifest(What)).

manifest_ko(fact(Term)) -->
    [ '작업 목록의 사실이 아닙니다: ~p'-[Term], nl,
      '  defaults([옵션, ...]) 또는 \c
       job(이름, 명령, [파일, ...], [옵션, ...])으로 쓰십시오.' ].
manifest_ko(verb(Verb, Near, All)) -->
    { atomic_list_concat(All, ', ', Text) },
    [ '작업이 될 수 없는 명령입니다: ~p'-[Verb] ],
    meant_ko(Near),
    [ nl, '  쓸 수 있는 명령: ~w.'-[Text] ].
manifest_ko(name(Name)) -->
    [ '작업의 이름이 될 수 없습니다: ~p'-[Name], nl,
      '  이름은 낱말, 수, 또는 hole(7) 같은 항입니다. 글자나 숫자가 있고 \c
       파일 이름이 될 만큼 짧아야 합니다.' ].
manifest_ko(files(Files)) -->
    [ '작업의 파일이 아닙니다: ~p'-[Files], nl,
      '  [\'tee.pl\'] 같은 리스트나 glob(\'*.obj\')로 쓰십시오. 표준 입력(-)은 \c
       쓸 수 없습니다.' ].
manifest_ko(missing(File)) -->
    [ '파일이 없습니다: ~w'-[File], nl,
      '  이름은 작업 목록이 있는 폴더의 것입니다.' ].
manifest_ko(option(Term)) -->
    [ '작업의 옵션이 아닙니다: ~p'-[Term], nl,
      '  명령의 긴 옵션을 항으로 쓰십시오: --view 30,60은 view(30, 60), \c
       --no-frame은 no_frame, output(\'%.svg\'), set(r, 7).' ].
manifest_ko(options(Term)) -->
    [ '옵션이 아닙니다: ~p'-[Term], nl,
      '  [view(isometric), output(\'%.svg\')] 같은 리스트로 쓰십시오.' ].
manifest_ko(no_default(Name)) -->
    [ '--~w 옵션이 있는 명령은 없습니다'-[Name], nl,
      '  defaults에는 명령의 옵션과 time_limit(초), memory(메가바이트), \c
       cpu(초)를 쓰십시오.' ].
manifest_ko(output(Pattern)) -->
    [ '작업의 파일 이름이 될 수 없습니다: ~w'-[Pattern], nl,
      '  작업 이름이 들어갈 자리에 %를, 마지막 부분에 한 번 쓰십시오: \c
       output(\'%.svg\'), output(\'plans/%.pdf\').' ].
manifest_ko(no_output(Verb)) -->
    [ '~w 작업은 파일을 쓰는데, 어떤 파일인지 쓰여 있지 않습니다'-[Verb], nl,
      '  output(\'%.확장자\')를 쓰거나, defaults([...])로 모든 작업에 주십시오.' ].
manifest_ko(ending(Pattern, Formats)) -->
    { atomic_list_concat(Formats, ' .', Text) },
    [ '~w: 이 명령이 쓰는 파일의 확장자가 아닙니다'-[Pattern], nl,
      '  쓸 수 있는 확장자: .~w'-[Text] ].
manifest_ko(folder_too(Name, Path)) -->
    [ '작업 ~w의 파일 ~w와(과) 이름이 같은 폴더를 다른 작업이 만듭니다'-
      [Name, Path], nl,
      '  output(\'폴더/%.확장자\')에서 폴더의 이름을 바꾸십시오.' ].
manifest_ko(limit(Term)) -->
    [ '작업의 한도가 아닙니다: ~p'-[Term], nl,
      '  초는 0보다 크고, 메모리는 50메가바이트 이상이어야 합니다.' ].
manifest_ko(unbound(Name)) -->
    [ '변수의 값을 정하는 것이 없습니다: ~w'-[Name], nl,
      '  job(...) @ ~w in 1..100처럼, 쓰는 곳보다 앞에 생성자를 쓰십시오.'-
      [Name] ].
manifest_ko(bound_twice(Name)) -->
    [ '두 생성자가 같은 변수의 값을 정합니다: ~w'-[Name], nl,
      '  둘째에는 다른 변수를 쓰십시오.' ].
manifest_ko(generator(Text)) -->
    [ '생성자가 아닙니다: ~w'-[Text], nl,
      '  R in 1..100, R in between(1, 2, 0.5), R in [a, b], \c
       F in glob(\'*.obj\'), [R, H] in rows(\'sizes.csv\', [r, h])로 쓰십시오.' ].
manifest_ko(range(Source)) -->
    [ '양 끝이 정수가 아닙니다: ~w'-[Source], nl,
      '  다른 수에는 between(1, 2, 0.5)를 쓰십시오.' ].
manifest_ko(steps(Step)) -->
    [ '간격이 될 수 없습니다: ~p'-[Step], nl,
      '  0보다 큰 수를 쓰십시오.' ].
manifest_ko(glob(Pattern)) -->
    [ '맞는 파일이 없습니다: ~w'-[Pattern], nl,
      '  이름은 작업 목록이 있는 폴더의 것입니다.' ].
manifest_ko(rows(File, _, missing)) -->
    [ '표가 없습니다: ~w'-[File], nl,
      '  이름은 작업 목록이 있는 폴더의 것입니다.' ].
manifest_ko(rows(File, Line, no_table)) -->
    [ '~w:~d: 표의 행이 아닙니다'-[File, Line], nl,
      '  첫 줄에는 열의 이름이 쉼표로 나뉘어 있어야 합니다.' ].
manifest_ko(rows(File, Line, not_utf8)) -->
    [ '~w:~d: UTF-8이 아닌 바이트가 있습니다'-[File, Line], nl,
      '  표를 UTF-8로 저장하십시오.' ].
manifest_ko(rows(File, Line, width(N, Wanted))) -->
    [ '~w:~d: 이 행의 값은 ~d개, 첫 줄은 ~d개입니다'-[File, Line, N, Wanted],
      nl, '  쉼표가 든 값은 따옴표로 묶으십시오.' ].
manifest_ko(rows(File, _, no_column(Column, Known))) -->
    { atomic_list_concat(Known, ', ', All) },
    [ '~w: 열이 없습니다: ~w'-[File, Column], nl,
      '  첫 줄에 있는 열: ~w.'-[All] ].
manifest_ko(json(_)) -->
    [ 'JSON 객체가 아닙니다', nl,
      '  한 줄에 하나씩 쓰십시오: \c
       {"job":"tee", "verb":"draw", "files":["tee.pl"], \c
       "options":{"output":"%.svg"}}.' ].
manifest_ko(no_key(Key)) -->
    [ '객체에 "~w" 키가 없습니다'-[Key], nl,
      '  작업에는 "job", "verb", "files", "options"를 쓰십시오.' ].
manifest_ko(key(Key, Keys)) -->
    { atomic_list_concat(Keys, ', ', All) },
    [ '"~w" 키는 여기서 뜻이 없습니다'-[Key], nl,
      '  쓸 수 있는 키: ~w.'-[All] ].
manifest_ko(twice(Name, Name, _)) -->
    !,
    [ '두 작업의 이름이 같습니다: ~w'-[Name], nl,
      '  다른 이름을 주십시오. 틀의 이름에는 그 변수가 모두 들어 있어야 \c
       합니다.' ].
manifest_ko(twice(Name, Older, Path)) -->
    [ '두 작업이 같은 파일을 만듭니다: ~w, ~w: ~w'-[Older, Name, Path], nl,
      '  파일 이름에는 글자, 숫자, 점, -, _만 남습니다. 하나에 다른 이름을 \c
       주십시오.' ].
manifest_ko(no_jobs) -->
    [ '작업 목록에 작업이 없습니다', nl,
      '  job(이름, 명령, [파일, ...], [옵션, ...])으로 쓰십시오.' ].
manifest_ko(no_report) -->
    [ '일괄 작업 보고의 줄이 아닙니다', nl,
      '  batch --report가 쓴 파일을 주십시오.' ].

%!  batch_ko(+What)// is det.
%
%   The message for sanggwan(batch(What)).

batch_ko(summary(Pairs)) -->
    { findall(Text,
              ( member(Outcome-N, Pairs),
                N > 0,
                outcome_ko(Outcome, Word),
                format(atom(Text), '~w ~D', [Word, N]) ),
              Texts),
      ( Texts == [] -> All = '작업 없음' ; atomic_list_concat(Texts, ', ', All) )
    },
    [ '~w'-[All] ].
batch_ko(failed(Name, Why)) -->
    [ '작업 ~w: ~w'-[Name, Why] ].
batch_ko(no) -->
    [ '답이 없습니다' ].
batch_ko(cut_line(File, Line)) -->
    [ '~w:~d: 끊긴 줄이라 세지 않았습니다'-[File, Line] ].
batch_ko(looked_at(Count)) -->
    [ '작업 ~D개를 살펴보았습니다'-[Count] ].
batch_ko(sorted(Count)) -->
    [ '작업 ~D개를 살펴보았습니다. 이제 같은 이름이 있는지 찾습니다'-[Count] ].
batch_ko(timeout(Seconds)) -->
    [ '~w초 안에 끝나지 않았습니다'-[Seconds], nl,
      '  작업 목록의 time_limit(초)로 시간을 더 주십시오.' ].
batch_ko(ended(killed(Signal))) -->
    [ '작업하던 프로세스가 신호로 끝났습니다: ~w'-[Signal], nl,
      '  9는 컴퓨터에 메모리가 모자랄 때, 24는 작업 목록의 cpu(초) 때문에 \c
       올 수 있습니다.' ].
batch_ko(ended(exit(Status))) -->
    [ '작업하던 프로세스가 끝났습니다. 종료 코드: ~w'-[Status], nl,
      '  그 명령만 따로 실행하여 까닭을 보십시오.' ].
batch_ko(changed) -->
    [ '읽는 파일이 그사이에 바뀌었습니다', nl,
      '  일괄 작업을 다시 하십시오.' ].

outcome_ko(done, '끝남').
outcome_ko(cached, '이미 있음').
outcome_ko(failed, '실패').
outcome_ko(timeout, '시간 초과').
outcome_ko(killed, '강제로 끝남').

%!  batch_usage_ko(+What)// is det.
%
%   The message for usage_error(batch(What)).

batch_usage_ko(no_job(Name)) -->
    [ '그런 작업이 없습니다: ~w'-[Name], nl,
      '  sanggwan batch MANIFEST --list가 이름을 보입니다.' ].
batch_usage_ko(one_manifest(File)) -->
    [ '작업 목록은 하나여야 합니다. 둘째: ~w'-[File] ].
batch_usage_ko(no_folder(File)) -->
    [ '일괄 작업의 결과를 둘 수 없는 곳입니다: ~w'-[File], nl,
      '  -o FOLDER를 주십시오.' ].
batch_usage_ko(no_out) -->
    [ '결과를 어디에 둘까요? -o FOLDER를 주십시오' ].
batch_usage_ko(no_slurm) -->
    [ '--shard slurm은 Slurm 작업 배열의 태스크에서 씁니다', nl,
      '  스크립트에 #SBATCH --array=1-64를 쓰거나, --shard I/N을 쓰십시오.' ].
batch_usage_ko(slurm_list) -->
    [ 'Slurm 배열이 중간이 빈 목록입니다', nl,
      '  범위로 쓰십시오: #SBATCH --array=1-64. 한 부분만 다시 할 때는 \c
       --shard I/N.' ].
