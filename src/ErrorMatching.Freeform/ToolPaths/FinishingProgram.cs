using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Writes a tool path as a program for a control: modal words only if they change, coordinates rounded to the control's least
/// increment.</summary>
public static class FinishingProgram
{
    /// <summary>What everybody is told first of a program that calls no tool, because the job names none.</summary>
    public static string NoToolCall => SurfaceWarningForms.NoToolCall.Template;

    /// <summary>The file name of a stage's program: <c>finishing.nc</c>, <c>semi-finishing.nc</c> or <c>roughing.nc</c>.</summary>
    public static string FileOf(CuttingStage stage) => NameOf(stage) + ".nc";

    /// <summary>Writes the program to memory.</summary>
    /// <exception cref="ArgumentException">As for the other overload.</exception>
    /// <exception cref="InputException">As for the other overload.</exception>
    public static byte[] Write(
        ToolPath path,
        FreeformJob job,
        NcDialect dialect,
        CuttingStage stage = CuttingStage.Finishing,
        Marker? marker = null,
        FinishingTemplate? template = null)
    {
        using var stream = new MemoryStream();
        Write(path, job, dialect, stage, stream, marker, template);
        return stream.ToArray();
    }

    /// <summary>Writes the program to a stream. Passes are calculated while they are written, so memory is limited to one pass, however
    /// long the program is.</summary>
    /// <param name="path">The path.</param>
    /// <param name="job">The job: name, tool and its call, speed, feed, and the programmed point of the ball.</param>
    /// <param name="dialect">The control for which the path was planned.</param>
    /// <param name="stage">The stage that the program states.</param>
    /// <param name="stream">The output; it stays open.</param>
    /// <param name="marker">The comment by which a compensated program identifies its sources; null if it follows no measurement.</param>
    /// <param name="template">The text around the moves; null for the dialect's (<see cref="FinishingTemplate.For"/>).</param>
    /// <exception cref="ArgumentException">The path was planned for a control with a different least increment.</exception>
    /// <exception cref="InputException">Speed or feed of the job would be written as 0 (<c>rounds-to-zero</c>), or the template would
    /// change the moves of the path (<c>bad-template</c>).</exception>
    public static void Write(
        ToolPath path,
        FreeformJob job,
        NcDialect dialect,
        CuttingStage stage,
        Stream stream,
        Marker? marker = null,
        FinishingTemplate? template = null)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(dialect);
        ArgumentNullException.ThrowIfNull(stream);
        if (path.Decimals != dialect.MetricDecimals)
        {
            throw new ArgumentException(
                $"The path was rounded to {path.Decimals} decimals, but {dialect.Name} writes {dialect.MetricDecimals}.", nameof(dialect));
        }

        template = template is null || !dialect.HasCodes ? FinishingTemplate.For(dialect) : template;
        template.CheckAsksFor(job.Toolpath.Tool, "toolpath.tool");
        var values = new FinishingValues(path, job, stage, dialect, template.File);
        var (head, tail) = (values.Fill(template.Section(FinishingTemplate.Head)), values.Fill(template.Section(FinishingTemplate.Tail)));
        var tipBelow = job.Toolpath.ProgramsTip ? path.RadiusMm : 0;
        if (!template.Content.IsBuiltIn)
        {
            Check(path, tipBelow, dialect, template, head, tail);
        }

        stream.Write(marker is null ? head : marker.InsertInto(NcProgram.Read(head, dialect.Syntax)));
        var writer = new MoveWriter(stream, path.Decimals, tipBelow, Encoding.ASCII.GetBytes("F" + values.Feed), path.TravelCenterZ);
        foreach (var move in path.Moves())
        {
            writer.Write(move);
        }

        writer.Flush();
        stream.Write(tail);
    }

    // Moves are written in absolute millimeters, starting with a rapid at travel height. The text before them must establish this state.
    private static void Check(ToolPath path, double tipBelow, NcDialect dialect, FinishingTemplate template, byte[] head, byte[] tail)
    {
        var first = path.Moves().First().Center;
        var across = string.Create(CultureInfo.InvariantCulture, $"X{first.X:F6} Y{first.Y:F6}\n");
        var program = NcProgram.Read((byte[])[.. head, .. Encoding.ASCII.GetBytes(across), .. tail], dialect.Syntax);
        var run = NcInterpreter.Run(program, dialect);
        if (run.Refusal is { } refusal)
        {
            throw Fail($"the program that comes of it cannot be followed in the dialect {dialect.Name}: {refusal.Message}");
        }

        if (run.Problems is [var problem, ..])
        {
            var text = program.TextOf(program[problem.Block]);
            throw Fail($"the dialect {dialect.Name} does not understand \"{text}\" of the program that comes of it: {problem.Message}");
        }

        var block = Enumerable.Range(0, program.BlockCount).Last(b => program[b].Start <= head.Length);
        var motions = Enumerable.Range(0, run.Motions.Length).Select(i => run.Motions[i]).Where(m => m.Block == block).ToArray();
        var end = new Point3(first.X, first.Y, path.TravelCenterZ - tipBelow);
        if (motions is not [{ Kind: MotionKind.Rapid, UnknownEnd: AxisSet.None } move] || (move.End - end).Length > 1e-6)
        {
            throw Fail(string.Create(
                CultureInfo.InvariantCulture,
                $"behind @head the moves would not be rapid, absolute, in millimeters and at the height of travel, Z {end.Z:0.####}. ")
                + "End it with G0 Z{travel}, and write G90 and the code for millimeters before.");
        }

        InputException Fail(string what) => InputException.At("bad-template", template.File, what);
    }

    internal static string NameOf(CuttingStage stage) => stage switch
    {
        CuttingStage.Roughing => "roughing",
        CuttingStage.SemiFinishing => "semi-finishing",
        _ => "finishing",
    };
}
