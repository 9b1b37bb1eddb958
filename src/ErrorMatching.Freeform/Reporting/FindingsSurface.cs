using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The surface to cut in a report.</summary>
/// <param name="Name">Its name.</param>
/// <param name="DegreeU">Degree in u.</param>
/// <param name="DegreeV">Degree in v.</param>
/// <param name="PolesU">Number of poles in u.</param>
/// <param name="PolesV">Number of poles in v.</param>
/// <param name="ApproximationMm">Largest distance from the exact surface; zero if it was fitted to points.</param>
public sealed record FindingsSurface(string Name, int DegreeU, int DegreeV, int PolesU, int PolesV, double ApproximationMm)
{
    /// <summary>The surface of a compensation.</summary>
    public static FindingsSurface Of(CompensationResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        var spline = result.Surface.Spline;
        return new(
            result.Surface.Name, spline.KnotsU.Degree, spline.KnotsV.Degree, spline.CountU, spline.CountV, result.ApproximationMm);
    }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter json)
    {
        json.Text("name", Name);
        json.Count("degreeU", DegreeU);
        json.Count("degreeV", DegreeV);
        json.Count("polesU", PolesU);
        json.Count("polesV", PolesV);
        json.Number("approximationUm", ApproximationMm * 1000);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static FindingsSurface Read(ReportReader json) => new(
        json.Text("name"),
        json.Count("degreeU"),
        json.Count("degreeV"),
        json.Count("polesU"),
        json.Count("polesV"),
        json.Micrometers("approximationUm"));
}
