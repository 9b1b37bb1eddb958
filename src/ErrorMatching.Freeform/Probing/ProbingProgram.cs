using System.Globalization;
using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The program that touches the points of a plan. The ball's center moves along each normal from the approach to the overtravel,
/// and the program logs where the probe triggers.</summary>
/// <remarks>All coordinates are those of the ball's center in the work offset of the surface, rounded to the control's least increment.
/// For the format of the log, see <see cref="MeasuredSurfaceReader"/>.</remarks>
public sealed class ProbingProgram
{
    private readonly ProbingValues _values;

    private ProbingProgram(ProbingMoves moves, NcDialect dialect, ProbingTemplate template, ProbingValues values)
    {
        (Moves, Dialect, Template, _values) = (moves, dialect, template, values);
        Bytes = Encoding.UTF8.GetBytes(Text(
            [ProbingTemplate.Head, ProbingTemplate.Definitions, ProbingTemplate.Body, ProbingTemplate.Tail], behind: null));
    }

    /// <summary>Its moves.</summary>
    public ProbingMoves Moves { get; }

    /// <summary>The dialect of the control.</summary>
    public NcDialect Dialect { get; }

    /// <summary>The template.</summary>
    public ProbingTemplate Template { get; }

    /// <summary>The standalone program.</summary>
    public ReadOnlyMemory<byte> Bytes { get; }

    /// <summary>The file that the control needs beside the program, with its name; null if it needs none.</summary>
    public (string Name, ReadOnlyMemory<byte> Bytes)? Beside => Template.BesideName is { } name
        ? (name, Encoding.UTF8.GetBytes(Text([ProbingTemplate.Beside], behind: null)))
        : null;

    /// <summary>Creates the program for the plan of a surface.</summary>
    /// <param name="plan">A plan without refusals.</param>
    /// <param name="job">Name of the job, for a comment.</param>
    /// <param name="dialect">The control.</param>
    /// <param name="template">As for <see cref="Of(ProbingMoves, string, NcDialect, ProbingTemplate, string?)"/>.</param>
    /// <param name="order">The shop's order number, for a comment; null if there is none.</param>
    /// <exception cref="InputException">As for the other one.</exception>
    /// <exception cref="ArgumentException">The plan has refusals or no points.</exception>
    public static ProbingProgram Of(
        MeasuringPlan plan, string job, NcDialect dialect, ProbingTemplate template, string? order = null)
    {
        ArgumentNullException.ThrowIfNull(plan);
        return plan.Refusals.Count > 0 || plan.Points.Count == 0
            ? throw new ArgumentException("The plan cannot be used.", nameof(plan))
            : Of(ProbingMoves.Of(plan), job, dialect, template, order);
    }

    /// <summary>Creates the program for given moves.</summary>
    /// <param name="moves">The moves, at least one touch.</param>
    /// <param name="job">Name of the job, for a comment.</param>
    /// <param name="dialect">The control.</param>
    /// <param name="template">The template for the control, probe or shop: <see cref="ProbingTemplate.Named"/> with the dialect's name, or
    /// a shop's own.</param>
    /// <param name="order">The shop's order number, for a comment; null if there is none.</param>
    /// <exception cref="InputException">The dialect cannot interpret the result of the template (<c>bad-template</c>), or a value of
    /// the job would be written as 0 (<c>rounds-to-zero</c>), or the template cannot touch in the direction of a point
    /// (<c>untouchable-point</c>).</exception>
    public static ProbingProgram Of(
        ProbingMoves moves, string job, NcDialect dialect, ProbingTemplate template, string? order = null)
    {
        ArgumentNullException.ThrowIfNull(moves);
        ArgumentNullException.ThrowIfNull(dialect);
        ArgumentNullException.ThrowIfNull(template);
        template.CheckAsksFor(moves.Tool, moves.ToolKey);
        moves = moves with { Assumed = [.. moves.Assumed, .. template.Assumes] };
        template.CheckAsksForAssumed(moves.Assumed);
        var program = new ProbingProgram(moves, dialect, template, new(moves, job, order, dialect, template.File));
        program.Check();
        return program;
    }

    /// <summary>The plan's identifier in a log: 16 hexadecimal digits of the SHA-256 of <see cref="PlanCsv"/>.</summary>
    public static string PlanId(MeasuringPlan plan) => ContentHash.Sha256(PlanCsv.Write(plan))[..16].ToUpperInvariant();

    /// <summary>Merges a program for one run of the control: semi-finishing, then probing, then a stop for the finishing program (Lee
    /// 2019, section 2.1).</summary>
    /// <param name="semiFinishing">A program in the same dialect and work offset.</param>
    /// <param name="file">Its name, for messages.</param>
    /// <param name="cutsIn">The dialect of the job's cutting programs, for messages.</param>
    /// <exception cref="InputException">The dialect does not know a code of the program, its end cannot be found, or probing would
    /// move differently after it (<c>not-mergeable</c>). The program is too large.</exception>
    public ReadOnlyMemory<byte> MergeAfter(ReadOnlyMemory<byte> semiFinishing, string file, string? cutsIn = null)
    {
        // The surface cut by a program that follows a measurement must not be compensated like a nominal one, so the log records this.
        var markers = Marker.Find(NcProgram.Read(semiFinishing, Dialect.Syntax));
        var behind = new ProbedBehind(
            markers is [var (_, marker), ..] ? marker?.MeasurementSha256.ToUpperInvariant() ?? ProbedBehind.Damaged : null);
        return new ProbingMerge(this, file, cutsIn).After(
            semiFinishing, Text([ProbingTemplate.Definitions], behind), Text([ProbingTemplate.Body], behind));
    }

    private void Check()
    {
        var program = NcProgram.Read(Bytes, Dialect.Syntax);
        var path = NcInterpreter.Run(program, Dialect);
        if (path.Refusal is { } refusal)
        {
            throw InputException.At(
                "bad-template",
                Template.File,
                $"the program that comes of it cannot be followed in the dialect {Dialect.Name}: {refusal.Message}");
        }

        if (path.Problems.Count > 0)
        {
            var problem = path.Problems[0];
            throw InputException.At(
                "bad-template",
                Template.File,
                $"the dialect {Dialect.Name} does not understand a block of the program that comes of it, "
                    + $"\"{program.TextOf(program[problem.Block])}\": {problem.Message}");
        }
    }

    private string Text(string[] sections, ProbedBehind? behind)
    {
        var text = new StringBuilder();
        foreach (var section in sections)
        {
            Write(text, Template.Section(section), null, behind);
        }

        return text.ToString();
    }

    private void Write(
        StringBuilder text, IReadOnlyList<TemplateItem> items, ProbingTouch? point, ProbedBehind? behind) => TemplateText.Write(
        text,
        items,
        condition => _values.Holds(condition, point, behind),
        place => _values[place, point, behind],
        _values.Line,
        body =>
        {
            foreach (var each in Moves.Touches)
            {
                Write(text, body, each, behind);
            }
        },
        refused => InputException.At("untouchable-point", Template.File, string.Create(
            CultureInfo.InvariantCulture,
            $"{NameOf(point!)} faces ({point!.Normal.X:0.###}, {point.Normal.Y:0.###}, {point.Normal.Z:0.###}): {refused.Text}. Choose "
                + $"another template, or write one of your own.")));

    private static string NameOf(ProbingTouch point) => point.Name.Length > 0 ? $"point {point.Name}"
        : FormattableString.Invariant($"point {point.Number}");
}
