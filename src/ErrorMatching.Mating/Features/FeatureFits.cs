using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Fits of a feature's straight elements; geometry errors name the feature.</summary>
internal static class FeatureFits
{
    public static LineFit Line(string feature, LineMethod method, IReadOnlyList<Point2> points, double uncertaintyMm) => Named(
        feature,
        () => method == LineMethod.Ordinary ? LineFit.Ordinary(points, uncertaintyMm) : LineFit.Total(points, uncertaintyMm));

    public static Wedge Wedge(string feature, IReadOnlyList<Point2> first, IReadOnlyList<Point2> second, double uncertaintyMm) =>
        Named(feature, () => Geometry.Wedge.Fit(first, second, uncertaintyMm));

    /// <summary>The angle inside the corner between two consecutive elements: between the reversed direction of the first and the
    /// direction of the second (equation 1 of Wang 2021). Collinear elements give 180 degrees.</summary>
    public static Angle Inside(LineFit first, LineFit second) => Angle.Between(-first.Line.Direction, second.Line.Direction);

    public static T Named<T>(string feature, Func<T> fit)
    {
        try
        {
            return fit();
        }
        catch (GeometryException e)
        {
            throw new GeometryException(e.Error, $"{feature}: {e.Message}");
        }
    }
}
