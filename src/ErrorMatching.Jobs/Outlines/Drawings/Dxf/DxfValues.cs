using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>The groups of one entity by their codes. Buffers are used again for the next entity.</summary>
/// <param name="groups">The file.</param>
internal sealed class DxfValues(DxfGroups groups)
{
    private const int FirstExtended = 1000;
    private readonly List<(int Code, (int Offset, int Line) Position)> _all = [];
    private string _label = "";
    private (int Offset, int Line) _next;

    /// <summary>Reads the groups of an entity.</summary>
    public void Read(DxfEntity entity)
    {
        groups.Position = entity.Start;
        Fill(entity.Label);
    }

    /// <summary>Reads the groups of the next VERTEX after a POLYLINE or a VERTEX; false if there is none.</summary>
    public bool ReadVertex(DxfEntity entity)
    {
        groups.Position = _next;
        groups.Next();
        if (!groups.Text.SequenceEqual("VERTEX"u8))
        {
            return false;
        }

        Fill(entity.Label);
        return true;
    }

    /// <summary>The first value of a code as a number; null if there is none.</summary>
    public double? Number(int code) => Find(code) ? groups.Number(_label) : null;

    /// <summary>The first value of a code as a number, or what the format takes if there is none.</summary>
    public double Number(int code, double otherwise) => Number(code) ?? otherwise;

    /// <summary>The first value of a code as a whole number, or what the format takes if there is none.</summary>
    public int Integer(int code, int otherwise) => Find(code) ? groups.Integer(_label) : otherwise;

    /// <summary>The first value of a code as a name; null if there is none.</summary>
    public string? Name(int code, DxfFile file) => Find(code) ? file.Name() : null;

    /// <summary>All values of a code as numbers.</summary>
    public List<double> Numbers(int code)
    {
        List<double> numbers = [];
        foreach (var (found, position) in _all)
        {
            if (found == code)
            {
                Go(position);
                numbers.Add(groups.Number(_label));
            }
        }

        return numbers;
    }

    /// <summary>The vertices of an LWPOLYLINE, and whether one has a width.</summary>
    public (List<(Point2 At, double Bulge)> Vertices, bool IsWide) Vertices()
    {
        List<(Point2 At, double Bulge)> vertices = [];
        var (isWide, hasY) = (false, true);
        foreach (var (code, position) in _all)
        {
            if (code is not (10 or 20 or 40 or 41 or 42))
            {
                continue;
            }

            Go(position);
            var value = groups.Number(_label);
            if (code == 10 ? !hasY : code == 20 ? hasY : vertices.Count == 0)
            {
                throw OutOfOrder(code);
            }

            switch (code)
            {
                case 10:
                    vertices.Add((new(value, 0), 0));
                    hasY = false;
                    break;
                case 20:
                    vertices[^1] = (new(vertices[^1].At.X, value), 0);
                    hasY = true;
                    break;
                case 42:
                    vertices[^1] = (vertices[^1].At, value);
                    break;
                default:
                    isWide |= value != 0;
                    break;
            }
        }

        return hasY ? (vertices, isWide) : throw OutOfOrder(10);
    }

    /// <summary>The points of a code, of the one 10 more, and of the one 20 more if the file has it.</summary>
    public List<Point3> Points(int code)
    {
        var (x, y, z) = (Numbers(code), Numbers(code + 10), Numbers(code + 20));
        if (x.Count != y.Count || (z.Count != 0 && z.Count != x.Count))
        {
            throw groups.Fail("bad-record", string.Create(
                CultureInfo.InvariantCulture,
                $"{_label}: {x.Count}, {y.Count} and {z.Count} coordinates in groups {code}, {code + 10} and {code + 20}; equally many "
                    + $"are expected"));
        }

        List<Point3> points = new(x.Count);
        for (var i = 0; i < x.Count; i++)
        {
            points.Add(new(x[i], y[i], z.Count > 0 ? z[i] : 0));
        }

        return points;
    }

    private InputException OutOfOrder(int code) => groups.Fail("bad-record", string.Create(
        CultureInfo.InvariantCulture, $"{_label}: group {code} out of order; 10 and 20 of each vertex are expected, then its 40, 41, 42"));

    private void Fill(string label)
    {
        _label = label;
        _all.Clear();

        // Other programs keep data between 102 { and 102 }, with any codes, and after 1000.
        var isForeign = false;
        for (_next = groups.Position; ; _next = groups.Position)
        {
            var position = groups.Position;
            groups.Next();
            switch (groups.Code)
            {
                case 0:
                    return;
                case 102:
                    isForeign = groups.Text.StartsWith("{"u8);
                    break;
                case < FirstExtended when !isForeign:
                    _all.Add((groups.Code, position));
                    break;
            }
        }
    }

    private bool Find(int code)
    {
        foreach (var (found, position) in _all)
        {
            if (found == code)
            {
                Go(position);
                return true;
            }
        }

        return false;
    }

    private void Go((int Offset, int Line) position)
    {
        groups.Position = position;
        groups.Next();
    }
}
