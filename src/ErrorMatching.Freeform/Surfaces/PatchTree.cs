using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface divided into patches, to find the ways on which a ball meets any of it. Parts outside the region are
/// excluded.</summary>
/// <remarks>Results are based on bounds for the whole surface, not on samples. Patches are halved on demand and stay halved.</remarks>
internal sealed class PatchTree
{
    private const int MostPatches = 200_000;

    /// <summary>Patches as small as this are decided by their corners, mm:
    /// what they hide is less than the hundredth of a micrometre.</summary>
    private const double Smallest = 0.01;

    /// <summary>Distances are found to this length, mm.</summary>
    private const double Exact = 1e-4;

    private readonly SurfaceRegion _region;
    private readonly Node? _root;
    private int _patches;

    public PatchTree(PartSurface surface)
    {
        _region = surface.Region;
        var roots = new List<Node>();
        foreach (var patch in BezierPatch.Of(surface.Spline))
        {
            if (!IsOutside(patch))
            {
                roots.Add(new(patch));
            }
        }

        while (roots.Count > 1)
        {
            var pairs = new List<Node>((roots.Count + 1) / 2);
            for (var i = 0; i < roots.Count; i += 2)
            {
                pairs.Add(i + 1 < roots.Count ? new(roots[i], roots[i + 1]) : roots[i]);
            }

            roots = pairs;
        }

        _root = roots.Count > 0 ? roots[0] : null;
        HighestMm = _root is null ? double.NaN : Highest(_root, double.NegativeInfinity);
    }

    /// <summary>An upper bound of the surface's height, at most 0.01 mm too high.</summary>
    public double HighestMm { get; }

    /// <summary>A place of the surface as high as that, within 0.01 mm.</summary>
    public Point3 HighestPlace { get; private set; } = new(double.NaN, double.NaN, double.NegativeInfinity);

    /// <summary>True if some place of the surface is nearer to a point than a distance.</summary>
    /// <param name="point">The point.</param>
    /// <param name="normal">Unit normal of the surface at the point's foot, if it has one. Tests are fastest in this direction.</param>
    /// <param name="distanceMm">The distance.</param>
    public bool IsNearer(Point3 point, Vector3 normal, double distanceMm) =>
        _root is not null && IsNearer(_root, point, normal, distanceMm);

    /// <summary>The distance of a point from the surface, to a tenth of a micrometer, if it is less than a maximum.</summary>
    public double DistanceBelow(Point3 point, Vector3 normal, double mostMm)
    {
        var (low, high) = (0.0, mostMm);
        while (high - low > 1e-4)
        {
            var middle = (low + high) / 2;
            (low, high) = IsNearer(point, normal, middle) ? (low, middle) : (middle, high);
        }

        return high;
    }

    /// <summary>The place of the surface that is nearest to a straight way, within a tenth of a micrometer, if it is nearer than a
    /// distance; otherwise null.</summary>
    /// <param name="from">Start of the way.</param>
    /// <param name="to">Its end.</param>
    /// <param name="normal">Unit normal of the surface at the foot of an end. Tests are fastest in this direction.</param>
    /// <param name="distanceMm">The distance.</param>
    public Point3? PlaceNearer(Point3 from, Point3 to, Vector3 normal, double distanceMm)
    {
        var search = new WaySearch(from, to, normal, distanceMm);
        if (_root is not null)
        {
            Search(_root, search);
        }

        return search.Place;
    }

    private void Search(Node node, WaySearch search)
    {
        if (search.DistanceOf(node.Middle) >= search.Nearest + node.Radius)
        {
            return;
        }

        if (node.Patch is { } patch)
        {
            if (patch.IsBeyond(search.From, search.To, search.Normal, search.Nearest))
            {
                return;
            }

            foreach (var corner in patch.Corners)
            {
                search.Try(corner);
            }

            // Once a place is found, only places that are nearer by more than the accuracy are sought.
            var isExact = search.Place is not null && search.DistanceOf(node.Middle) - node.Radius >= search.Nearest - Exact;
            if (isExact || patch.Radius < Smallest)
            {
                return;
            }
        }

        Halve(node);
        var (first, second) = (node.First, node.Second);
        if (first is not null && second is not null && search.DistanceOf(second.Middle) < search.DistanceOf(first.Middle))
        {
            (first, second) = (second, first);
        }

        if (first is not null)
        {
            Search(first, search);
        }

        if (second is not null)
        {
            Search(second, search);
        }
    }

    private bool IsNearer(Node node, Point3 point, Vector3 normal, double distance)
    {
        var reach = distance + node.Radius;
        var to = point - node.Middle;
        if (to.Dot(to) >= reach * reach)
        {
            return false;
        }

        if (node.Patch is { } patch)
        {
            if (patch.IsBeyond(point, normal, distance))
            {
                return false;
            }

            if (patch.HasCornerNearer(point, distance))
            {
                return true;
            }

            if (patch.Radius < Smallest)
            {
                return false;
            }
        }

        Halve(node);
        return (node.First is { } first && IsNearer(first, point, normal, distance))
            || (node.Second is { } second && IsNearer(second, point, normal, distance));
    }

    private double Highest(Node node, double most)
    {
        if (node.Highest < most + Smallest)
        {
            return Math.Max(most, node.Highest);
        }

        foreach (var corner in node.Patch?.Corners ?? [])
        {
            HighestPlace = corner.Z > HighestPlace.Z ? corner : HighestPlace;
        }

        most = Math.Max(most, HighestPlace.Z);
        if (node.Highest < most + Smallest)
        {
            return node.Highest;
        }

        Halve(node);
        foreach (var half in (Node?[])[node.First, node.Second])
        {
            most = half is null ? most : Math.Max(most, Highest(half, most));
        }

        return most;
    }

    private void Halve(Node node)
    {
        if (node.IsHalved)
        {
            return;
        }

        if (_patches > MostPatches)
        {
            // Discards all halves. They are recreated on demand.
            _root!.Forget();
            _patches = 0;
        }

        _patches += 2;
        var (first, second) = node.Patch!.TwoThreads();
        node.Halve(IsOutside(first) ? null : new(first), IsOutside(second) ? null : new(second));
    }

    // No edge of the region enters the patch, and its center is outside.
    private bool IsOutside(BezierPatch patch)
    {
        if (_region.IsWhole)
        {
            return false;
        }

        var middle = patch.From.Lerp(patch.To, 0.5);
        if (_region.Contains(middle.X, middle.Y))
        {
            return false;
        }

        foreach (var loop in _region.Loops)
        {
            for (var i = 0; i < loop.Count; i++)
            {
                var (a, b) = (loop[i], loop[(i + 1) % loop.Count]);
                if (Math.Max(a.X, b.X) >= patch.From.X
                    && Math.Min(a.X, b.X) <= patch.To.X
                    && Math.Max(a.Y, b.Y) >= patch.From.Y
                    && Math.Min(a.Y, b.Y) <= patch.To.Y)
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>What is nearest to a straight way so far.</summary>
    private sealed class WaySearch(Point3 from, Point3 to, Vector3 normal, double distanceMm)
    {
        private readonly Vector3 _way = to - from;

        public Point3 From => from;

        public Point3 To => to;

        public Vector3 Normal => normal;

        public double Nearest { get; private set; } = distanceMm;

        public Point3? Place { get; private set; }

        public double DistanceOf(Point3 point)
        {
            var off = point - from;
            var square = _way.Dot(_way);
            return (off - (_way * (square > 0 ? Math.Clamp(off.Dot(_way) / square, 0, 1) : 0))).Length;
        }

        public void Try(Point3 place)
        {
            var distance = DistanceOf(place);
            (Nearest, Place) = distance < Nearest ? (distance, place) : (Nearest, Place);
        }
    }

    /// <summary>A patch, halved or not, or two combined nodes.</summary>
    private sealed class Node
    {
        public Node(BezierPatch patch) => (Patch, Middle, Radius, Highest) = (patch, patch.Middle, patch.Radius, patch.Highest);

        public Node(Node first, Node second)
        {
            (First, Second, IsHalved) = (first, second, true);
            var between = second.Middle - first.Middle;
            var apart = between.Length;
            Radius = Math.Max(Math.Max(first.Radius, second.Radius), (apart + first.Radius + second.Radius) / 2);
            Middle = first.Middle + (between * (apart > 0 ? Math.Clamp((Radius - first.Radius) / apart, 0, 1) : 0));
            Highest = Math.Max(first.Highest, second.Highest);
        }

        public BezierPatch? Patch { get; }

        public Node? First { get; private set; }

        public Node? Second { get; private set; }

        public bool IsHalved { get; private set; }

        public Point3 Middle { get; }

        public double Radius { get; }

        public double Highest { get; }

        public void Halve(Node? first, Node? second) => (First, Second, IsHalved) = (first, second, true);

        public void Forget()
        {
            if (Patch is null)
            {
                First?.Forget();
                Second?.Forget();
            }
            else
            {
                (First, Second, IsHalved) = (null, null, false);
            }
        }
    }
}
