using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A line on a surface along which one of its parameters is constant, through the measured point with the largest error.</summary>
internal sealed class SurfaceSection
{
    private const int Steps = 120;

    // A measured point is on the line if its other parameter differs by less than this share of the range.
    private const double SameLine = 0.01;

    private readonly ErrorSample _worst;
    private readonly bool _alongU;
    private readonly KnotVector _along;
    private readonly double _near;

    /// <summary>The section.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="samples">The measured errors, at least one.</param>
    /// <param name="alongU">True for a line along u, where v is constant.</param>
    public SurfaceSection(PartSurface surface, IReadOnlyList<ErrorSample> samples, bool alongU)
    {
        (_worst, _alongU) = (samples.MaxBy(s => Math.Abs(s.ErrorMm))!, alongU);
        var (along, across) = alongU
            ? (surface.Spline.KnotsU, surface.Spline.KnotsV)
            : (surface.Spline.KnotsV, surface.Spline.KnotsU);
        var places = new SectionPlace[Steps + 1];
        var length = 0.0;
        for (var k = 0; k <= Steps; k++)
        {
            var at = along.Start + ((along.End - along.Start) * k / Steps);
            var (u, v) = alongU ? (at, _worst.V) : (_worst.U, at);
            var point = surface.Spline.PointAt(u, v);
            length += k == 0 ? 0 : (point - surface.Spline.PointAt(places[k - 1].U, places[k - 1].V)).Length;
            places[k] = new(length, u, v, surface.Region.Contains(u, v));
        }

        (Places, LengthMm) = (places, length);
        (_along, _near) = (along, SameLine * (across.End - across.Start));
    }

    /// <summary>Places along the line, at equal steps of the parameter.</summary>
    public IReadOnlyList<SectionPlace> Places { get; }

    /// <summary>Its length.</summary>
    public double LengthMm { get; }

    /// <summary>Where it is, in words.</summary>
    public string Words => $"Along {(_alongU ? "u" : "v")} through point {ReportNumber.Count(_worst.Point)}, the one with the "
        + "largest error";

    /// <summary>The measured points on the line, each with its position along it, its error in micrometers and a tooltip.</summary>
    public IReadOnlyList<(double LengthMm, double ValueUm, string Title)> PointsOf(IReadOnlyList<ErrorSample> samples) => [
        .. samples.Where(s => Math.Abs(Across(s) - Across(_worst)) < _near)
            .OrderBy(Along)
            .Select(s => (
                LengthAt(Along(s)),
                1000 * s.ErrorMm,
                $"Point {ReportNumber.Count(s.Point)}: {Micrometres.SignedOfMm(s.ErrorMm)} µm"))];

    private double Along(ErrorSample s) => _alongU ? s.U : s.V;

    private double Across(ErrorSample s) => _alongU ? s.V : s.U;

    private double LengthAt(double parameter)
    {
        var step = Math.Clamp((parameter - _along.Start) / (_along.End - _along.Start), 0, 1) * Steps;
        var k = Math.Min((int)step, Steps - 1);
        return Places[k].LengthMm + ((step - k) * (Places[k + 1].LengthMm - Places[k].LengthMm));
    }
}

/// <summary>A place on a section.</summary>
/// <param name="LengthMm">Its distance from the beginning, along the line.</param>
/// <param name="U">Its first parameter.</param>
/// <param name="V">Its second parameter.</param>
/// <param name="IsInside">True if it belongs to the piece.</param>
internal sealed record SectionPlace(double LengthMm, double U, double V, bool IsInside);
