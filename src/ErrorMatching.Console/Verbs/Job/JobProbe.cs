using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Json;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job probe</c>.</summary>
internal sealed class JobProbe : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "A mating job, such as one of errormatch job plan." };
    private readonly Option<string> _out = FileOption(
        "--out",
        "The folder to write probe.nc to (or with the ending of the job's program), and what the control needs beside it. Without it "
            + "nothing is written.");

    private readonly Option<string> _piece = new("--piece")
    {
        Description = "The piece to touch: the part, or the counterpart that was cut.",
        DefaultValueFactory = _ => "part",
        HelpName = "part|counterpart",
    };

    private readonly Option<double?> _stylus = ProbeOptions.Stylus();
    private readonly Option<double?> _z = ProbeOptions.Height(
        "--z", "Height at which the center of the ball touches. Without it: half as deep as the features are cut, which is told.");

    private readonly Option<double?> _clearance = ProbeOptions.Height(
        "--clearance", "Height of the ball's center between points. Without it: above the highest move of the program, which is told.");

    private readonly Option<double?> _approach = ProbeOptions.Positive(
        "--approach", "Distance from the part at which a measuring move starts. Without it: 2 mm, less where there is no room.", "MM");

    private readonly Option<double?> _overtravel = ProbeOptions.Positive(
        "--overtravel",
        "How far a measuring move goes on behind the part as designed. Without it: 1 mm more than compensation.limitMm.",
        "MM");

    private readonly Option<double?> _feed = ProbeOptions.Positive("--feed", "Feed of the measuring move. Without it: 100.", "MM/MIN");
    private readonly Option<int?> _tool = new("--tool")
    {
        Description = "Number of the probe as a tool, and of its length offset. Without it the program stops for the probe.",
        HelpName = "NUMBER",
    };

    private readonly Option<string> _dialect = new("--dialect")
    {
        Description = "The control that measures. Without it: that of the job's program.",
        HelpName = "DIALECT",
    };

    private readonly Option<string> _template = FileOption(
        "--template",
        $"A built-in template ({string.Join(", ", ProbingTemplate.Names)}), or a file of your own. Without it: that of the dialect.");

    public JobProbe()
        : base(
            "probe",
            "Writes the program that touches the key points of the part on the machine.",
            "errormatch job probe samples/dovetail/job.json --stylus-diameter 3 --out out")
    {
        Arguments.Add(_job);
        Option[] options = [_out, _piece, _stylus, _z, _clearance, _approach, _overtravel, _feed, _tool, _dialect, _template];
        foreach (var option in options)
        {
            Options.Add(option);
        }

        _piece.AcceptOnlyFromAmong("part", "counterpart");
        _tool.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<int?>() is { } number && number is < 1 or > 99_999)
            {
                result.AddError(FormattableString.Invariant($"--tool is {number}; expected a number from 1 to 99999."));
            }
        });
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var outcome = ProbedJob.Make(
            arguments.GetRequiredValue(_job),
            new()
            {
                OfCounterpart = arguments.GetValue(_piece) == "counterpart",
                StylusDiameterMm = arguments.GetValue(_stylus),
                TouchZ = arguments.GetValue(_z),
                ClearanceZ = arguments.GetValue(_clearance),
                ApproachMm = arguments.GetValue(_approach),
                OvertravelMm = arguments.GetValue(_overtravel),
                FeedMmPerMin = arguments.GetValue(_feed),
                ToolNumber = arguments.GetValue(_tool),
                Dialect = arguments.GetValue(_dialect),
                Template = arguments.GetValue(_template),
            },
            cancellation);
        if (outcome.Result is not { } probed)
        {
            return new Failure(ExitCode.Refused, outcome.Refusals);
        }

        var files = new List<(string Path, ReadOnlyMemory<byte> Bytes)>();
        if (arguments.GetValue(_out) is { } folder)
        {
            files.Add((PathText.In(folder, probed.FileName), probed.Program.Bytes));
            if (probed.Program.Beside is { } beside)
            {
                files.Add((PathText.In(folder, beside.Name), beside.Bytes));
            }

            OutputFile.WriteAll(files, probed.Read, cancellation);
        }

        return new JobProbeAnswer(probed, [.. files.Select(f => f.Path)]);
    }
}
