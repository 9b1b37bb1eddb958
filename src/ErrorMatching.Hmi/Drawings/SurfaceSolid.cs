using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>A surface in space with its error exaggerated along the normal, as facets of one color each.</summary>
public sealed class SurfaceSolid
{
    /// <summary>Maximum number of facets. A finer net is thinned.</summary>
    public const int MostFacets = 4000;

    // Share of the surface's size that the largest error takes.
    private const double Share = 0.15;

    private readonly Vector3[] _places;
    private readonly List<SolidFacet> _facets = [];

    /// <summary>Raises the places of a surface by their values.</summary>
    /// <param name="drawing">The surface with its values.</param>
    public SurfaceSolid(SurfaceDrawing drawing)
    {
        Drawing = drawing ?? throw new ArgumentNullException(nameof(drawing));
        var (net, values) = (drawing.Net, drawing.ValuesMm ?? []);
        var size = drawing.Extent is { IsEmpty: false } box
            ? Math.Max(box.Right - box.Left, box.High - box.Low)
            : 1;
        var largest = values.Select(Math.Abs).DefaultIfEmpty().Max();
        Factor = largest > 0 ? Math.Max(1, RoundNumber.AtMost(Share * size / largest)) : 1;
        var middle = drawing.Extent is { IsEmpty: false, Middle: var m } ? m : Point2.Origin;
        var (low, high) = (net.Places.Min(p => p.Z), net.Places.Max(p => p.Z));
        var center = new Point3(middle.X, middle.Y, (low + high) / 2);
        _places = [
            .. Enumerable.Range(0, net.Places.Count).Select(
                p => net.Places[p] - center + (NormalAt(net, p) * (values.Count > 0 ? Factor * values[p] : 0)))];
        Radius = _places.Select(p => new Vector3(p.X, p.Y, 0).Length).DefaultIfEmpty(1).Max();
        HalfHeight = _places.Select(p => Math.Abs(p.Z)).DefaultIfEmpty().Max();
        Points = [.. drawing.Points.Select(p => PlaceUnder(net, p.At))];
        Divide(net, values);
    }

    /// <summary>The surface seen from above.</summary>
    public SurfaceDrawing Drawing { get; }

    /// <summary>How many times the error is enlarged.</summary>
    public double Factor { get; }

    /// <summary>Distance of the farthest place from the vertical axis through the middle.</summary>
    public double Radius { get; }

    /// <summary>Height of the highest place above the middle, or the depth of the lowest.</summary>
    public double HalfHeight { get; }

    /// <summary>The drawing's points on the raised surface, from the middle.</summary>
    public IReadOnlyList<Vector3> Points { get; }

    /// <summary>The facets, in no particular order.</summary>
    public IReadOnlyList<SolidFacet> Facets => _facets;

    /// <summary>The facets in a turn, the farthest first: what is drawn later covers what is behind it.</summary>
    public IReadOnlyList<(SolidFacet Facet, Point2[] Corners)> Ordered(SurfaceTurn turn)
    {
        var places = Array.ConvertAll(_places, turn.Project);
        return [
            .. _facets
                .Select(f => (Facet: f, Corners: f.Places.Select(p => places[p]).ToArray()))
                .OrderBy(f => f.Corners.Sum(c => c.Nearness))
                .Select(f => (f.Facet, f.Corners.Select(c => c.At).ToArray()))];
    }

    // The normal that points up: what is cut from above has no other side.
    private static Vector3 NormalAt(SurfaceNet net, int place)
    {
        var (i, j) = (place / net.CountV, place % net.CountV);
        var alongU = At(Math.Min(i + 1, net.CountU - 1), j) - At(Math.Max(i - 1, 0), j);
        var alongV = At(i, Math.Min(j + 1, net.CountV - 1)) - At(i, Math.Max(j - 1, 0));
        var normal = alongU.Cross(alongV);
        return normal.Length == 0 ? new(0, 0, 1) : (normal.Z < 0 ? -normal : normal).Normalize();

        Point3 At(int u, int v) => net.Places[(u * net.CountV) + v];
    }

    // A point on a curved border may be beside the net's straight one.
    private Vector3 PlaceUnder(SurfaceNet net, Point2 at) => NetPlaces.Under(net, at) is var (u, v)
        ? NetPlaces.PositionAt(net with { Places = [.. _places.Select(p => default(Point3) + p)] }, u, v) - default(Point3)
        : Enumerable.Range(0, _places.Length).MinBy(p => new Point2(net.Places[p].X, net.Places[p].Y).DistanceTo(at)) is var nearest
        ? _places[nearest]
        : default;

    private void Divide(SurfaceNet net, IReadOnlyList<double> values)
    {
        var outside = net.Outside.ToHashSet();
        var step = 1;
        while (Steps(net.CountU, step) * Steps(net.CountV, step) > MostFacets)
        {
            step++;
        }

        for (var i = 0; i < net.CountU - 1; i += step)
        {
            for (var j = 0; j < net.CountV - 1; j += step)
            {
                var (behindU, behindV) = (Math.Min(i + step, net.CountU - 1), Math.Min(j + step, net.CountV - 1));
                if (outside.Contains(((i + behindU - 1) / 2 * (net.CountV - 1)) + ((j + behindV - 1) / 2)))
                {
                    continue;
                }

                int[] places = [
                    (i * net.CountV) + j, (behindU * net.CountV) + j, (behindU * net.CountV) + behindV, (i * net.CountV) + behindV];
                _facets.Add(new(
                    places,
                    values.Count > 0 ? DivergingColors.IndexOf(places.Average(p => values[p]), Drawing.LimitMm) : -1));
            }
        }
    }

    private static int Steps(int count, int step) => (count - 1 + step - 1) / step;
}

/// <summary>A facet of a surface in space.</summary>
/// <param name="Places">The places of the net at its corners, in order.</param>
/// <param name="Color">Index of its color; -1 if there are no values.</param>
public sealed record SolidFacet(IReadOnlyList<int> Places, int Color);
