using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface cut into patches so small that each is nearly flat, to be asked whether the ball reaches into any of it. Parts outside the region of the piece are left out.</summary>
/// <remarks>Answers are by bounds that hold for every place of the surface, not for samples of it.</remarks>
internal sealed class PatchTree
{
    private const int MostPatches = 400_000;
    private const int Deepest = 40;

    private readonly SurfaceRegion _region;
    private readonly double _thickness;
    private readonly double _size;
    private readonly List<Node> _nodes = [];
    private readonly int _root;

    /// <param name="surface">The surface.</param>
    /// <param name="thicknessMm">How far apart the planes may be that hold a patch.</param>
    /// <param name="sizeMm">How large a patch may be.</param>
    public PatchTree(PartSurface surface, double thicknessMm, double sizeMm)
    {
        (_region, _thickness, _size) = (surface.Region, thicknessMm, sizeMm);
        var roots = new List<int>();
        foreach (var patch in BezierPatch.Of(surface.Spline))
        {
            if (Grow(patch, 0) is { } node)
            {
                roots.Add(node);
            }
        }

        while (roots.Count > 1)
        {
            var pairs = new List<int>((roots.Count + 1) / 2);
            for (var i = 0; i < roots.Count; i += 2)
            {
                pairs.Add(i + 1 < roots.Count ? Join(roots[i], roots[i + 1]) : roots[i]);
            }

            roots = pairs;
        }

        _root = roots.Count > 0 ? roots[0] : -1;
        HighestMm = _root < 0 ? double.NaN : _nodes[_root].Box.Max.Z;
    }

    /// <summary>Height that no place of the surface exceeds, and that it reaches within the size of a patch.</summary>
    public double HighestMm { get; }

    /// <summary>True if some place of the surface is nearer to a point than a distance. What is nearer by less than the hundredth of a micrometre may be passed over.</summary>
    public bool IsNearer(Point3 point, double distanceMm)
    {
        if (_root < 0)
        {
            return false;
        }

        Span<int> stack = stackalloc int[Deepest + 64];
        var count = 0;
        stack[count++] = _root;
        while (count > 0)
        {
            var node = _nodes[stack[--count]];
            if (node.Box.DistanceTo(point) >= distanceMm)
            {
                continue;
            }

            if (node.Patch is { } patch)
            {
                if (IsNearer(patch, point, distanceMm, 0))
                {
                    return true;
                }
            }
            else
            {
                (stack[count], stack[count + 1]) = (node.First, node.Second);
                count += 2;
            }
        }

        return false;
    }

    /// <summary>The distance of a point from the surface, to the tenth of a micrometre, if it is less than another.</summary>
    public double DistanceBelow(Point3 point, double mostMm)
    {
        var (low, high) = (0.0, mostMm);
        while (high - low > 1e-4)
        {
            var middle = (low + high) / 2;
            (low, high) = IsNearer(point, middle) ? (low, middle) : (middle, high);
        }

        return high;
    }

    private static bool IsNearer(BezierPatch patch, Point3 point, double distance, int depth)
    {
        if (patch.LeastDistance(point) >= distance)
        {
            return false;
        }

        if (patch.CornerDistance(point) < distance)
        {
            return true;
        }

        if (depth == Deepest || patch.High - patch.Low < 1e-5)
        {
            // Flat: what is left is the part of a plane between the corners.
            return patch.Box.Diagonal > 0.01 && depth < Deepest && Halve();
        }

        return Halve();

        bool Halve()
        {
            var (first, second) = patch.Halves();
            return IsNearer(first, point, distance, depth + 1) || IsNearer(second, point, distance, depth + 1);
        }
    }

    private int? Grow(BezierPatch patch, int depth)
    {
        if (IsOutside(patch))
        {
            return null;
        }

        var size = patch.Box.Diagonal;
        if ((size <= _size && patch.High - patch.Low <= _thickness) || size < 0.02 || depth == Deepest || _nodes.Count >= MostPatches)
        {
            _nodes.Add(new(patch.Box, patch, -1, -1));
            return _nodes.Count - 1;
        }

        var (first, second) = patch.Halves();
        return (Grow(first, depth + 1), Grow(second, depth + 1)) switch
        {
            ({ } a, { } b) => Join(a, b),
            var (a, b) => a ?? b,
        };
    }

    private int Join(int a, int b)
    {
        var (one, other) = (_nodes[a].Box, _nodes[b].Box);
        _nodes.Add(new(Box3.Around([one.Min, one.Max, other.Min, other.Max]), null, a, b));
        return _nodes.Count - 1;
    }

    // No edge of the region enters the patch, and its middle is outside.
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
                if (Math.Max(a.X, b.X) >= patch.From.X && Math.Min(a.X, b.X) <= patch.To.X && Math.Max(a.Y, b.Y) >= patch.From.Y && Math.Min(a.Y, b.Y) <= patch.To.Y)
                {
                    return false;
                }
            }
        }

        return true;
    }

    private readonly record struct Node(Box3 Box, BezierPatch? Patch, int First, int Second);
}
