using System.CommandLine;
using System.Diagnostics;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary><c>errormatch match</c>.</summary>
internal sealed class MatchVerb : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string> _part = FileOption("--part", "The measured part, instead of the job's.");
    private readonly Option<string> _counterpart = FileOption("--counterpart", "The measured counterpart, instead of the job's.");
    private readonly Option<string> _program = FileOption("--program", "The counterpart's program, instead of the job's.");
    private readonly WishOption _wish = new();
    private readonly Option<string> _out = new("--out") { Description = "The folder to write the program and the reports to. Without it nothing is written.", HelpName = "DIR" };

    /// <summary>The verb.</summary>
    public MatchVerb()
        : base("match", "Makes the counterpart's program follow the measured part, and proves what it changed.", "errormatch match samples/complex-mating/job.json --out out")
    {
        Arguments.Add(_job);
        Options.Add(_part);
        Options.Add(_counterpart);
        Options.Add(_program);
        Options.Add(_out);
        Options.Add(_wish);
    }

    /// <inheritdoc/>
    public override Outcome Run(ParseResult arguments, CancellationToken cancellation)
    {
        var clock = Stopwatch.StartNew();
        var files = new JobFiles(arguments.GetRequiredValue(_job));
        var (theoretical, part) = (files.Theoretical(), files.Part(arguments.GetValue(_part)));
        var counterpart = CounterpartOf(files.Job, arguments.GetValue(_counterpart)) is { } measured ? files.Counterpart(measured) : null;
        var (program, bytes) = files.Program(arguments.GetValue(_program));
        var dialect = files.OwnDialect();
        cancellation.ThrowIfCancellationRequested();
        try
        {
            var outcome = Matcher.Match(new(files.Job, theoretical, part, counterpart, program, bytes) { OwnDialect = dialect });
            if (outcome.Result is not { } result)
            {
                return FailureOf.Refused(files.Job.File, program, outcome.Refusals);
            }

            var folder = arguments.GetValue(_out);
            var name = Path.GetFileName(program);
            var report = MatchReporter.Report(result, folder is null ? name : Path.Combine(folder, name), clock.Elapsed.TotalSeconds);
            var answer = new MatchAnswer(report, folder);
            _wish.WriteWith(folder is null ? [] : answer.Files(result.Program), result.WishFile, arguments, files.Read, cancellation);

            return answer;
        }
        catch (GeometryException e)
        {
            return FailureOf.Geometry(e, part.File);
        }
    }

    // In feed-forward the counterpart need not exist yet, whatever the job says about its measurement.
    private static string? CounterpartOf(MatingJob job, string? given) =>
        given ?? (job.Compensation.From == CompensationSource.Counterpart && job.Counterpart.Measured is { } measured ? job.PathOf(measured) : null);
}
