using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Reads the geometry of entities from their groups.</summary>
/// <param name="file">The file.</param>
/// <param name="notes">Receives what is passed over.</param>
internal sealed class DxfGeometry(DxfFile file, DxfNotes notes)
{
    // Relative tilt up to which a plane is parallel to XY: it changes a circle of 1 m by less than 1e-9 mm.
    private const double MaxTilt = 1e-6;

    private readonly DxfGroups _groups = file.Groups;
    private readonly DxfValues _values = new(file.Groups);

    /// <summary>Reads the pieces of an entity; none if they are passed over.</summary>
    public IReadOnlyList<DrawnShape> Read(DxfEntity entity)
    {
        _values.Read(entity);
        switch (entity.Kind)
        {
            case "LINE":
                return Line(entity);
            case "SPLINE":
                return new DxfSplineValues(_values, _groups, notes).Read(entity);
        }

        // All others have a plane.
        var plane = Plane(entity);
        if (plane is not { } map)
        {
            return [];
        }

        return entity.Kind switch
        {
            "ARC" => Arc(entity, map),
            "CIRCLE" => Circle(entity, map),
            "ELLIPSE" => Ellipse(entity, map.IsMirror),
            "LWPOLYLINE" => Lightweight(entity, map),
            "POLYLINE" => Polyline(entity, map),
            _ => throw new InvalidOperationException(entity.Kind),
        };
    }

    /// <summary>Reads an INSERT.</summary>
    public DxfInsert ReadInsert(DxfEntity entity)
    {
        _values.Read(entity);
        var name = _values.Name(2, file) ?? throw Fail(entity, "bad-record", "no name of a block in group 2; one is expected");
        var block = file.Block(name)
            ?? throw Fail(
                entity, "bad-block", $"block {DrawingLimits.Quote(name)}, which the file does not have; a block of the file is expected");
        var (columns, rows) = (_values.Integer(70, 1), _values.Integer(71, 1));
        (columns, rows) = (columns == 0 ? 1 : columns, rows == 0 ? 1 : rows);
        if (columns < 0 || rows < 0 || (long)columns * rows > DxfLimits.MaxVisits)
        {
            throw Fail(entity, "too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"{columns} columns and {rows} rows; 1 to {DxfLimits.MaxVisits} copies are expected"));
        }

        var scale = new Vector2(_values.Number(41, 1), _values.Number(42, 1));
        if (scale.X == 0 || scale.Y == 0)
        {
            throw Fail(entity, "bad-value", "a scale of 0; another number is expected in groups 41 and 42");
        }

        if (Plane(entity) is not { } plane)
        {
            return new(new(name), default, default, 0, 0, default);
        }

        var outer = plane.After(PlaneMap.Shift(new(_values.Number(10, 0), _values.Number(20, 0))))
            .After(PlaneMap.Rotation(_values.Number(50, 0)));
        var inner = PlaneMap.Scaling(scale.X, scale.Y).After(PlaneMap.Shift(Point2.Origin - block.Base));
        return new(block, outer, inner, columns, rows, new(_values.Number(44, 0), _values.Number(45, 0)));
    }

    // The arbitrary axis algorithm of the format turns X around for a plane seen from below, and keeps Y.
    private PlaneMap? Plane(DxfEntity entity)
    {
        var (x, y, z) = (_values.Number(210, 0), _values.Number(220, 0), _values.Number(230, 1));
        if (x == 0 && y == 0 && z == 0)
        {
            throw Fail(entity, "bad-value", "an extrusion direction without length; 0, 0, 1 is expected in groups 210, 220 and 230");
        }

        if (!(Math.Abs(x) + Math.Abs(y) <= MaxTilt * Math.Abs(z)))
        {
            notes.Count(DxfNote.Tilted, entity);
            return null;
        }

        return z > 0 ? PlaneMap.Scaling(1, 1) : PlaneMap.FromBelow;
    }

    private DrawnShape[] Line(DxfEntity entity)
    {
        var (from, to) = (Point(entity, 10), Point(entity, 11));
        if (_values.Number(30, 0) != _values.Number(31, 0))
        {
            notes.Count(DxfNote.Sloped, entity);
        }

        return [new SegmentShape(from, to)];
    }

    private DrawnShape[] Arc(DxfEntity entity, in PlaneMap plane)
    {
        var (start, end) = (Required(entity, 50), Required(entity, 51));
        var turn = Math.IEEERemainder(end - start, 360);
        turn += turn < 0 ? 360 : 0;

        // 0 to 360 degrees is a circle; twice the same angle is nothing.
        turn = turn == 0 && end != start ? 360 : turn;
        return Round(entity, plane, start * (Math.PI / 180), turn * (Math.PI / 180));
    }

    private DrawnShape[] Circle(DxfEntity entity, in PlaneMap plane) => Round(entity, plane, 0, Math.Tau);

    private DrawnShape[] Round(DxfEntity entity, in PlaneMap plane, double start, double sweep)
    {
        var (center, radius) = (Point(entity, 10), Required(entity, 40));
        if (radius < 0)
        {
            throw Fail(entity, "bad-value", string.Create(
                CultureInfo.InvariantCulture, $"a radius of {radius} in group 40; a positive number is expected"));
        }

        if (radius == 0)
        {
            notes.Count(DxfNote.NoSize, entity);
            return [];
        }

        return [new EllipseShape(plane.Of(center), plane.X * radius, plane.Y * radius, start, sweep)];
    }

    private DrawnShape[] Ellipse(DxfEntity entity, bool isFromBelow)
    {
        // Unlike arcs, ellipses have their points in the coordinates of the block.
        var (center, axis) = (Point(entity, 10), Point(entity, 11) - Point2.Origin);
        var ratio = Required(entity, 40);
        var (start, end) = (_values.Number(41, 0), _values.Number(42, Math.Tau));
        if (ratio < 0)
        {
            throw Fail(entity, "bad-value", string.Create(
                CultureInfo.InvariantCulture, $"an axis ratio of {ratio} in group 40; a positive number is expected"));
        }

        if (ratio == 0 || axis.Length == 0)
        {
            notes.Count(DxfNote.NoSize, entity);
            return [];
        }

        if (_values.Number(31, 0) != 0)
        {
            notes.Count(DxfNote.Tilted, entity);
            return [];
        }

        var sweep = end - start;
        if (Math.Abs(sweep) < Math.Tau - 1e-9 || sweep < 0)
        {
            sweep = Math.IEEERemainder(sweep, Math.Tau);
            sweep += sweep < 0 ? Math.Tau : 0;
        }

        return [new EllipseShape(center, axis, (isFromBelow ? -axis.Left : axis.Left) * ratio, start, Math.Min(sweep, Math.Tau))];
    }

    private DrawnShape[] Lightweight(DxfEntity entity, in PlaneMap plane)
    {
        var (vertices, isWide) = _values.Vertices();
        if (_values.Integer(90, vertices.Count) is var stated && stated != vertices.Count)
        {
            throw Fail(entity, "bad-record", string.Create(
                CultureInfo.InvariantCulture, $"{vertices.Count} vertices; group 90 says {stated}"));
        }

        if (isWide || _values.Number(43, 0) != 0)
        {
            notes.Count(DxfNote.Wide, entity);
        }

        return Joined(vertices, (_values.Integer(70, 0) & 1) != 0, plane);
    }

    private DrawnShape[] Polyline(DxfEntity entity, in PlaneMap plane)
    {
        const int Closed = 1, Space = 8, Meshes = 16 | 64, Frame = 16, SplineFit = 8;
        var flags = _values.Integer(70, 0);
        if ((flags & Meshes) != 0)
        {
            notes.Count(DxfNote.Mesh, entity);
            return [];
        }

        var isWide = _values.Number(40, 0) != 0 || _values.Number(41, 0) != 0;
        List<(Point2 At, double Bulge)> vertices = [];
        var (isSloped, isFit, height) = (false, false, double.NaN);
        while (_values.ReadVertex(entity))
        {
            var kind = _values.Integer(70, 0);
            if ((kind & Frame) != 0)
            {
                continue;
            }

            isFit |= (kind & SplineFit) != 0;
            isWide |= _values.Number(40, 0) != 0 || _values.Number(41, 0) != 0;
            var z = _values.Number(30, 0);
            isSloped |= z != height && !double.IsNaN(height);
            height = z;
            vertices.Add((Point(entity, 10), (flags & Space) != 0 ? 0 : _values.Number(42, 0)));
        }

        Count(isWide, DxfNote.Wide);
        Count(isFit, DxfNote.Approximated);
        Count(isSloped && (flags & Space) != 0, DxfNote.Sloped);
        return Joined(vertices, (flags & Closed) != 0, (flags & Space) != 0 ? PlaneMap.Scaling(1, 1) : plane);

        void Count(bool applies, DxfNote note)
        {
            if (applies)
            {
                notes.Count(note, entity);
            }
        }
    }

    private static DrawnShape[] Joined(List<(Point2 At, double Bulge)> vertices, bool isClosed, in PlaneMap plane)
    {
        var count = isClosed && vertices.Count > 1 ? vertices.Count : Math.Max(0, vertices.Count - 1);
        var shapes = new DrawnShape[count];
        for (var i = 0; i < count; i++)
        {
            var (from, to) = (plane.Of(vertices[i].At), plane.Of(vertices[(i + 1) % vertices.Count].At));
            var bulge = plane.IsMirror ? -vertices[i].Bulge : vertices[i].Bulge;
            shapes[i] = bulge == 0 ? new SegmentShape(from, to) : new BulgeShape(from, to, bulge);
        }

        return shapes;
    }

    private Point2 Point(DxfEntity entity, int code) => new(Required(entity, code), Required(entity, code + 10));

    private double Required(DxfEntity entity, int code) => _values.Number(code) ?? throw Fail(
        entity, "bad-record", string.Create(CultureInfo.InvariantCulture, $"no group {code}; {entity.Kind} needs it"));

    private InputException Fail(DxfEntity entity, string code, string problem) =>
        _groups.FailAt(code, entity.Place, $"{entity.Label}: {problem}");
}
