using System.CommandLine;
using System.Runtime.CompilerServices;
using System.Text;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job new</c>.</summary>
internal sealed class JobNew : Verb
{
    private readonly Argument<string> _kind = JobKind.Argument();
    private readonly Argument<string> _file = new("FILE") { Description = "The job to write. A file that exists is not overwritten." };

    private readonly Option<string> _outline = FileOption(
        "--outline",
        "Of a mating job: the drawing (.dxf), or the model whose flat face it is (.stp, .step), with the outline that mates. It is laid on "
            + "what --program cuts.");

    private readonly Option<string> _layer = new("--layer")
    {
        Description = "The layer of the drawing with that outline, or the flat face of the model (45 for #45). One needs no name.",
        HelpName = "NAME",
    };

    private readonly Option<string> _program = FileOption("--program", "The counterpart's program, with --outline.");
    private readonly Option<string> _dialect = NcVerb.DialectOption();
    private readonly Option<double?> _tool = new("--tool-diameter")
    {
        Description = "Diameter of the tool in mm. Without it, the distance of the outline from the path tells it.",
        HelpName = "MM",
    };

    private readonly Option<string> _unit = new("--unit")
    {
        Description = "The drawing's unit, where it says none or a wrong one.",
        HelpName = "mm|inch",
    };

    public JobNew()
        : base("new", "Writes a commented job, or configuration of a cell, to start from.", "errormatch job new mating out/job.json")
    {
        Arguments.Add(_kind);
        Arguments.Add(_file);
        Options.Add(_outline);
        Options.Add(_layer);
        Options.Add(_program);
        Options.Add(_dialect);
        Options.Add(_tool);
        Options.Add(_unit);
        _unit.AcceptOnlyFromAmong("mm", "inch");
        _tool.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<double?>() is { } mm && !(mm is > 0 and <= 1000))
            {
                result.AddError($"--tool-diameter is {mm}; expected a diameter above 0 and up to 1000 mm.");
            }
        });
        Validators.Add(result =>
        {
            var (hasOutline, hasProgram) = (result.GetResult(_outline) is not null, result.GetResult(_program) is not null);
            if (hasOutline != hasProgram)
            {
                result.AddError("--outline and --program belong together: the drawing is laid on what the program cuts.");
            }
            else if (hasOutline && result.GetValue(_kind) != JobKind.Mating)
            {
                result.AddError("--outline makes a mating job: errormatch job new mating FILE --outline DRAWING --program NC.");
            }
        });
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var file = arguments.GetRequiredValue(_file);
        var kind = arguments.GetRequiredValue(_kind);
        if (arguments.GetValue(_outline) is { } outline)
        {
            return FromOutline(file, outline, arguments, cancellation);
        }

        OutputFile.Create(file, Encoding.UTF8.GetBytes(TextOf(kind)), cancellation);
        return new JobNewAnswer(file, kind == JobKind.Cell ? "cell check" : "job check");
    }

    private VerbResult FromOutline(string file, string outline, ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("laying the outline on the program");
        var outcome = OutlineJob.Make(
            new(file, outline, arguments.GetRequiredValue(_program), arguments.GetRequiredValue(_dialect))
            {
                Layer = arguments.GetValue(_layer),
                ToolDiameterMm = arguments.GetValue(_tool),
                UnitMm = arguments.GetValue(_unit) switch { "mm" => 1, "inch" => 25.4, _ => null },
            },
            cancellation);
        if (outcome.Result is not { } made)
        {
            return new Failure(ExitCode.Refused, outcome.Refusals);
        }

        var theoretical = Path.Combine(Path.GetDirectoryName(file) ?? "", OutlineJob.TheoreticalFile);
        OutputFile.CreateAll([(theoretical, made.Theoretical), (file, made.Job)], made.Read, cancellation);
        return new JobNewFromOutlineAnswer(file, theoretical, made);
    }

    private static string TextOf(string kind) => kind switch
    {
        JobKind.Freeform => FreeformTemplate.Text,
        JobKind.Cell => CellText(),
        _ => JobTemplate.Text,
    };

    // A method of its own, so that a job does not load the cell.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static string CellText() => CellTemplate.Text;
}

/// <summary>A new job or configuration.</summary>
/// <param name="file">The file.</param>
/// <param name="check">The verb that checks it.</param>
internal sealed class JobNewAnswer(string file, string check) : DocumentAnswer
{
    public override string Schema => "errormatch/job-new/1";

    public override void WriteJson(Utf8JsonWriter json) => json.WriteString("file", file);

    public override void WriteText(Page page)
    {
        page.Line($"Wrote {file}. Name your files in it and what belongs to them, then: errormatch {check} {file}");
    }
}
