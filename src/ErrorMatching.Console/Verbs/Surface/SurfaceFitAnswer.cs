using System.Globalization;
using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A fitted surface and its reliability.</summary>
/// <param name="file">The points.</param>
/// <param name="count">The number of points.</param>
/// <param name="fit">The surface.</param>
/// <param name="d1">Distances of the points.</param>
/// <param name="d2">Distances of the true surface's points; null if none are given.</param>
/// <param name="folder">The folder that the surface was written to; null if nothing was written.</param>
internal sealed class SurfaceFitAnswer(string file, int count, FittedSurface fit, DistanceSummary d1, DistanceSummary? d2, string? folder)
    : DocumentAnswer
{
    private const double UmPerMm = 1000;

    public override string Schema => "errormatch/surface-fit/1";

    /// <summary>The surface for other programs, and for a job.</summary>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> Files
    {
        get
        {
            var surface = new PartSurface(Path.GetFileNameWithoutExtension(file), fit.Surface, SurfaceRegion.Whole, 1);
            return [(In("surface.stp"), StepWriter.Write(surface)), (In("surface.igs"), IgesWriter.Write(surface))];
        }
    }

    private string Method => fit.Method.Name;

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteNumber("count", count);
        json.WriteString("method", Method);
        json.WriteNumber("degreeU", fit.Surface.KnotsU.Degree);
        json.WriteNumber("degreeV", fit.Surface.KnotsV.Degree);
        json.WriteNumber("polesU", fit.Surface.CountU);
        json.WriteNumber("polesV", fit.Surface.CountV);
        WriteBreaks(json);
        Write(json, "d1", d1);
        if (d2 is { } distance)
        {
            Write(json, "d2", distance);
        }

        json.Number("leaveLineOutUm", fit.LeaveLineOutMm * UmPerMm);
        if (fit.MissedMm > 0)
        {
            json.Number("missedUm", fit.MissedMm * UmPerMm);
            json.WriteBoolean("throughPoints", fit.IsThroughPoints);
        }
    }

    public override void WriteText(Page page)
    {
        page.Heading(string.Create(CultureInfo.InvariantCulture, $"Surface {Method}, {ReportNumber.Count(count, "point")} of {file}"));
        page.Line();
        page.Table(
            ["", "degree", "poles", "breaks at"],
            [
                ["u", Show.Exact(fit.Surface.KnotsU.Degree), Show.Exact(fit.Surface.CountU), Places(fit.BreaksU)],
                ["v", Show.Exact(fit.Surface.KnotsV.Degree), Show.Exact(fit.Surface.CountV), Places(fit.BreaksV)],
            ]);
        page.Line();
        List<IReadOnlyList<string>> rows = [["d1 of the points", Um(d1.MeanMm), Um(d1.MaxMm)]];
        if (d2 is { } distance)
        {
            rows.Add(["d2 of the true surface", Um(distance.MeanMm), Um(distance.MaxMm)]);
        }

        rows.Add(["with whole lines left out", double.IsNaN(fit.LeaveLineOutMm) ? "too few lines" : Um(fit.LeaveLineOutMm), ""]);
        page.Table(["distance along the normal in µm", "mean", "largest"], rows);
        page.Line();
        if (fit.MissedMm > 0)
        {
            page.Warning(
                $"the points lie {Um(fit.MissedMm)} µm off the best smooth surface, in the mean, and that is no noise: it has a "
                    + (fit.IsThroughPoints
                        ? "structure. The surface passes through every point instead, and so through the noise of each. Measure more "
                            + "points."
                        : "structure, which the surface misses. Measure more points."));
            page.Line();
        }

        page.Line(folder is null
            ? "Nothing was written. Add --out DIR to write the surface as STEP and IGES."
            : $"Wrote {In("surface.stp")} and {In("surface.igs")}. Next: name one of them as \"surface\" in a job, and look at errormatch "
                + $"surface plan.");
    }

    private string In(string name) => PathText.In(folder, name);

    private static string Um(double mm) => (mm * UmPerMm).ToString("0.0000", CultureInfo.InvariantCulture);

    private static string Places(IReadOnlyList<double> breaks) =>
        string.Join(' ', breaks.Select(b => b.ToString("0.0000", CultureInfo.InvariantCulture)));

    private static void Write(Utf8JsonWriter json, string name, DistanceSummary distance)
    {
        json.WriteStartObject(name);
        json.Number("meanUm", distance.MeanMm * UmPerMm);
        json.Number("maxUm", distance.MaxMm * UmPerMm);
        json.WriteEndObject();
    }

    /// <summary>Each break with its direction, its parameter, and a place in the middle of the surface, which a person can find on the
    /// piece.</summary>
    private void WriteBreaks(Utf8JsonWriter json)
    {
        json.WriteStartArray("breaks");
        foreach (var u in fit.BreaksU)
        {
            Write(json, "u", u, fit.Surface.PointAt(u, Middle(fit.Surface.KnotsV)));
        }

        foreach (var v in fit.BreaksV)
        {
            Write(json, "v", v, fit.Surface.PointAt(Middle(fit.Surface.KnotsU), v));
        }

        json.WriteEndArray();
    }

    private static void Write(Utf8JsonWriter json, string direction, double parameter, Point3 at)
    {
        json.WriteStartObject();
        json.WriteString("direction", direction);
        json.Number("parameter", parameter);
        json.Number("x", at.X);
        json.Number("y", at.Y);
        json.Number("z", at.Z);
        json.WriteEndObject();
    }

    private static double Middle(KnotVector knots) => (knots.Start + knots.End) / 2;
}
