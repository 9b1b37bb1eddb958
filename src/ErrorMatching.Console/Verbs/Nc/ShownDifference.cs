using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The displacement of a motion, in words for scripts and people.</summary>
internal static class ShownDifference
{
    /// <summary>The word for a change.</summary>
    public static string Word(MotionChange change) => change switch
    {
        MotionChange.Moved => "moved",
        MotionChange.Replaced => "replaced",
        MotionChange.Feed => "feed",
        MotionChange.Inserted => "inserted",
        MotionChange.Removed => "removed",
        MotionChange.Tool => "tool",
        MotionChange.Spindle => "spindle",
        _ => "words",
    };

    /// <summary>The displacement of an arc's center; null unless both motions are arcs.</summary>
    public static Vector3? Center(MotionComparison comparison, MotionDifference difference)
    {
        if (difference.Before < 0 || difference.After < 0 || comparison.Before.Motions[difference.Before] is not { IsArc: true } arc)
        {
            return null;
        }

        return arc.Plane.Lift(Point2.Origin + difference.CenterDisplacement, 0) - default(Point3);
    }

    /// <summary>A vector as three cells of a table.</summary>
    public static string[] Cells(Vector3? vector) =>
        vector is { } v ? [ShownMotion.Text(v.X), ShownMotion.Text(v.Y), ShownMotion.Text(v.Z)] : ["", "", ""];

    /// <summary>Writes a vector as <c>{ "x", "y", "z" }</c>, rounded to remove binary noise.</summary>
    public static void WriteVector(Utf8JsonWriter json, string name, Vector3? vector)
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

    private static double Clean(double value) => Math.Round(value, 9) + 0.0;
}
