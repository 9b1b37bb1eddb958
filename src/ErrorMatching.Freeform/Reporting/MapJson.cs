using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes the map of an error into a report, and reads it.</summary>
internal static class MapJson
{
    /// <summary>Writes it into the open object, without the heights of the places.</summary>
    public static void Write(ReportWriter json, ErrorMap map)
    {
        json.Count("countU", map.Net.CountU);
        json.Count("countV", map.Net.CountV);
        json.Numbers("x", map.Net.Places.Select(p => p.X));
        json.Numbers("y", map.Net.Places.Select(p => p.Y));
        json.Numbers("outside", map.Net.Outside.Select(c => (double)c));
        json.Numbers("errorUm", map.BeforeMm.Select(e => e * 1000));
        json.Numbers("mirrorUm", map.MirrorMm.Select(e => e * 1000));
        json.Numbers("toolRadiusUm", map.ToolRadiusMm.Select(e => e * 1000));
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    public static ErrorMap Read(ReportReader json)
    {
        var (countU, countV) = ((long)json.Count("countU"), (long)json.Count("countV"));
        var places = json.Numbers("x", countU * countV).Zip(json.Numbers("y", countU * countV), (x, y) => new Point3(x, y, 0));
        var outside = json.Counts("outside");
        if (countU < 2 || countV < 2)
        {
            throw json.Refusal(countU < 2 ? "countU" : "countV", "too-small", "at least 2");
        }

        return outside.Any(c => c >= (countU - 1) * (countV - 1))
            ? throw json.Refusal("outside", "too-large", "numbers of cells")
            : new(new((int)countU, (int)countV, [.. places], outside), Mm("errorUm"), Mm("mirrorUm"), Mm("toolRadiusUm"));

        double[] Mm(string name) => [.. json.Numbers(name, countU * countV).Select(e => e / 1000)];
    }
}
