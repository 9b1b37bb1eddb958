using System.CommandLine;
using System.Diagnostics;
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
    private readonly Option<string> _previous = new("--previous")
    {
        Description = "In feedback, the report.json of the match whose program cut the measured counterpart: all counterparts measured so "
            + "far count.",
        HelpName = "REPORT",
    };

    private readonly Option<string> _latest = new("--latest")
    {
        Description = "In feedback, the report.json of the last match, if other counterparts were measured since the program of this one "
            + "was made: they count, too.",
        HelpName = "REPORT",
    };

    private readonly Option<bool> _toolChanged = new("--tool-changed")
    {
        Description = "With --previous or --latest: the tool was changed before the measured counterpart was cut, so what it shows is "
            + "believed at once.",
    };

    private readonly AssumeOption _assume = new();
    private readonly WishOption _wish = new();
    private readonly CertificateOption _certificate = new();
    private readonly AcceptOption _accept = new(MatchedProgram.Acceptable);
    private readonly Option<string> _out = new("--out")
    {
        Description = "The folder to write the program and the reports to. Without it nothing is written.",
        HelpName = "DIR"
    };

    public MatchVerb()
        : base(
            "match",
            "Makes the counterpart's program follow the measured part, and proves what it changed.",
            CommandTree.Example)
    {
        Arguments.Add(_job);
        Options.Add(_part);
        Options.Add(_counterpart);
        Options.Add(_program);
        Options.Add(_previous);
        Options.Add(_latest);
        Options.Add(_toolChanged);
        Options.Add(_assume.Option);
        Options.Add(_out);
        Options.Add(_wish);
        Options.Add(_certificate);
        Options.Add(_accept);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var clock = Stopwatch.StartNew();
        using var progress = new LateProgress(ProgressTo);
        progress.Report("matching the program");
        var files = new JobFiles(arguments.GetRequiredValue(_job));
        var folder = arguments.GetValue(_out);
        var outcome = MatingRun.Run(
            files,
            new()
            {
                Part = GivenMeasurement(arguments.GetValue(_part)),
                Counterpart = GivenMeasurement(arguments.GetValue(_counterpart)),
                Program = GivenFile.At(arguments.GetValue(_program)),
                Previous = GivenFile.At(arguments.GetValue(_previous)),
                Latest = GivenFile.At(arguments.GetValue(_latest)),
                ToolChanged = arguments.GetValue(_toolChanged),
                Assumed = _assume.Of(arguments),
                Folder = folder,
                ElapsedS = () => clock.Elapsed.TotalSeconds,
            },
            cancellation);
        if (outcome.Result is not { } matched)
        {
            return new Failure(ExitCode.Refused, outcome.Refusals);
        }

        var accepted = _accept.Of(arguments);
        var obedient = matched.Obey(accepted);
        var answer = new MatchAnswer(
            obedient,
            folder,
            FailureOf.NotToCut(
                obedient.Report.Acceptance,
                VerdictWords.Of(obedient.Report.Verdict),
                files.Job.File,
                folder is null ? [] : matched.Report.Targets,
                files.Opened));
        var outputs = folder is null ? [] : matched.FilesIn(folder, accepted);
        if (!obedient.Report.Acceptance.IsWithheld)
        {
            outputs = _certificate.Before(outputs, matched.Match.Certificate, arguments);
            outputs = _wish.Before(outputs, matched.Match.WishFile, arguments);
        }

        if (outputs.Count > 0)
        {
            OutputFile.WriteAll(outputs, files.Opened, cancellation);
        }

        return answer;
    }
}
