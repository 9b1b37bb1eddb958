using System.Globalization;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The motions in which two programs differ.</summary>
internal sealed class NcDiffAnswer(string before, string after, MotionComparison comparison) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/nc-diff/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("before", before);
        json.WriteString("after", after);
        json.WriteString("dialect", comparison.Before.Dialect.Name);
        json.WriteBoolean("sameBytes", comparison.Before.Program.Bytes.Span.SequenceEqual(comparison.After.Program.Bytes.Span));
        json.WriteNumber("motionsBefore", comparison.Before.Motions.Length);
        json.WriteNumber("motionsAfter", comparison.After.Motions.Length);
        json.WriteStartArray("motions");
        foreach (var difference in comparison.Differences)
        {
            var (was, now) = Sides(difference);
            json.WriteStartObject();
            json.WriteString("change", Word(difference.Change));
            json.WriteString("block", (was ?? now)!.Block);
            json.WriteNumber("line", (was ?? now)!.Line);
            WriteVector(json, "displacement", was is null || now is null ? null : difference.Displacement);
            WriteVector(json, "centerDisplacement", Center(difference));
            WriteSide(json, "before", was);
            WriteSide(json, "after", now);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    /// <inheritdoc/>
    public override void WriteText(Page page)
    {
        page.Heading(comparison.Differences.Count == 0
            ? $"{before} and {after} do the same"
            : string.Create(CultureInfo.InvariantCulture, $"{comparison.Differences.Count} motions differ between {before} and {after}"));
        if (comparison.Differences.Count == 0)
        {
            return;
        }

        page.Line();
        page.Table(
            ["line", "block", "change", "dx", "dy", "dz", "center dx", "dy", "dz"],
            comparison.Differences.Select(d => (IReadOnlyList<string>)[.. Place(d), Word(d.Change), .. Cells(d.Before < 0 || d.After < 0 ? null : d.Displacement), .. Cells(Center(d))]));
    }

    private static string Word(MotionChange change) => change switch
    {
        MotionChange.Moved => "moved",
        MotionChange.Replaced => "replaced",
        MotionChange.Feed => "feed",
        MotionChange.Inserted => "inserted",
        _ => "removed",
    };

    private static string[] Cells(Vector3? vector) => vector is { } v ? [ShownMotion.Text(v.X), ShownMotion.Text(v.Y), ShownMotion.Text(v.Z)] : ["", "", ""];

    private static void WriteVector(Utf8JsonWriter json, string name, Vector3? vector)
    {
        if (vector is not { } v)
        {
            json.WriteNull(name);
            return;
        }

        json.WriteStartObject(name);
        json.Number("x", Clean(v.X));
        json.Number("y", Clean(v.Y));
        json.Number("z", Clean(v.Z));
        json.WriteEndObject();
    }

    private static void WriteSide(Utf8JsonWriter json, string name, ShownMotion? motion)
    {
        if (motion is null)
        {
            json.WriteNull(name);
            return;
        }

        json.WriteStartObject(name);
        motion.Write(json);
        json.WriteEndObject();
    }

    private static double Clean(double value) => Math.Round(value, 9) + 0.0;

    private Vector3? Center(MotionDifference difference)
    {
        if (difference.Before < 0 || difference.After < 0 || comparison.Before.Motions[difference.Before] is not { IsArc: true } arc)
        {
            return null;
        }

        return arc.Plane.Lift(Point2.Origin + difference.CenterDisplacement, 0) - default(Point3);
    }

    private IEnumerable<string> Place(MotionDifference difference)
    {
        var (was, now) = Sides(difference);
        return [(was ?? now)!.Line.ToString(CultureInfo.InvariantCulture), (was ?? now)!.Block];
    }

    private (ShownMotion? Before, ShownMotion? After) Sides(MotionDifference difference) =>
        (difference.Before < 0 ? null : new(comparison.Before, difference.Before), difference.After < 0 ? null : new(comparison.After, difference.After));
}
