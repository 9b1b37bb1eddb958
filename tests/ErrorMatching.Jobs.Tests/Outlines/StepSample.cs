using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Writes small STEP files, one instance a line.</summary>
internal sealed class StepSample
{
    public const string Millimeter = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))";

    /// <summary>An inch by its definition.</summary>
    public const string Inch = "(CONVERSION_BASED_UNIT('INCH',#5)LENGTH_UNIT()NAMED_UNIT(#6));"
        + "#5=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#3);#6=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)";

    private const int Header = 8;
    private const int First = 10;

    private readonly List<string> _lines = [];
    private readonly List<string> _faces = [];

    /// <summary>The faces in order: of a plate those of its sides, outline by outline, then its top and its bottom.</summary>
    public IReadOnlyList<string> Faces => _faces;

    /// <summary>The tangent by which the planes of a plate's sides lean.</summary>
    public double Slope { get; init; }

    /// <summary>True to write the faces as those of a solid, so that their normals point out of it.</summary>
    public bool IsSolid { get; init; }

    /// <summary>The line on which an instance begins.</summary>
    public static int LineOf(string instance) => Header + int.Parse(instance.AsSpan(1), CultureInfo.InvariantCulture) - First;

    /// <summary>Adds an instance, and returns the reference to it.</summary>
    public string Add(FormattableString content)
    {
        _lines.Add(FormattableString.Invariant($"#{_lines.Count + First}={content.ToString(CultureInfo.InvariantCulture)};"));
        return FormattableString.Invariant($"#{_lines.Count + First - 1}");
    }

    /// <summary>Takes a face out of the file: its edges are then those of its neighbors alone.</summary>
    public void Lose(string face)
    {
        var at = _lines.FindIndex(l => l.StartsWith(face + "=ADVANCED_FACE", StringComparison.Ordinal));
        _lines[at] = $"{face}=DESCRIPTIVE_REPRESENTATION_ITEM('','');";
    }

    public string Point(Point3 p) => Add($"CARTESIAN_POINT('',({Real(p.X)},{Real(p.Y)},{Real(p.Z)}))");

    public string Direction(Vector3 v) => Add($"DIRECTION('',({Real(v.X)},{Real(v.Y)},{Real(v.Z)}))");

    public string Vertex(Point3 p) => Add($"VERTEX_POINT('',{Point(p)})");

    public string Placement(Point3 origin, Vector3 axis, Vector3 reference) =>
        Add($"AXIS2_PLACEMENT_3D('',{Point(origin)},{Direction(axis)},{Direction(reference)})");

    public string Plane(Point3 origin, Vector3 normal) =>
        Add($"PLANE('',{Placement(origin, normal, Math.Abs(normal.X) < 0.5 ? new(1, 0, 0) : new(0, 1, 0))})");

    public string Line(Point3 from, Point3 to) =>
        Add($"LINE('',{Point(from)},{Add($"VECTOR('',{Direction((to - from).Normalize())},1.)")})");

    public string Circle(Point3 center, double radius, double axis = 1) =>
        Add($"CIRCLE('',{Placement(center, new(0, 0, axis), new(0.6, 0.8, 0))},{Real(radius)})");

    /// <summary>An edge, and the use of it in a loop.</summary>
    public string Edge(string from, string to, string curve, bool sameSense = true, bool forward = true) =>
        Oriented(Add($"EDGE_CURVE('',{from},{to},{curve},{Flag(sameSense)})"), forward);

    public string Oriented(string edge, bool forward) => Add($"ORIENTED_EDGE('',*,*,{edge},{Flag(forward)})");

    /// <summary>The edges of a polygon.</summary>
    public string[] Polygon(params Point3[] corners)
    {
        string[] vertices = [.. corners.Select(Vertex)];
        return [
            .. corners.Select((p, i) => Edge(
                vertices[i], vertices[(i + 1) % corners.Length], Line(p, corners[(i + 1) % corners.Length])))];
    }

    public string Face(string surface, params string[][] loops) => Face("", surface, loops);

    /// <summary>A face with loops of edges.</summary>
    public string Face(string name, string surface, string[][] loops) =>
        FaceOf(name, surface, [.. loops.Select(l => Add($"EDGE_LOOP('',({string.Join(',', l)}))"))]);

    /// <summary>A face with a loop of any kind.</summary>
    public string FaceOf(string surface, string loop) => FaceOf("", surface, [loop]);

    private string FaceOf(string name, string surface, string[] loops)
    {
        string[] bounds = [.. loops.Select(l => Add($"FACE_BOUND('',{l},.T.)"))];
        _faces.Add(Add($"ADVANCED_FACE('{name}',({string.Join(',', bounds)}),{surface},.T.)"));
        return _faces[^1];
    }

    /// <summary>A plate between two heights, with its side faces. Edges are written in turn with and against their outline, circles about
    /// axes upward and downward.</summary>
    /// <param name="loops">Its outlines, closed.</param>
    /// <param name="bottom">The height of its bottom.</param>
    /// <param name="top">The height of its top.</param>
    /// <param name="unitMm">Millimeters in the unit of what is written.</param>
    public StepSample Plate(IReadOnlyList<IReadOnlyList<DrawnCurve>> loops, double bottom, double top, double unitMm = 1)
    {
        List<string[]> above = [], below = [];
        foreach (var loop in loops)
        {
            Point2[] corners = [.. loop.Select(c => c.From)];
            string[] low = [.. corners.Select(p => Vertex(At(p, bottom)))], high = [.. corners.Select(p => Vertex(At(p, top)))];
            string[] up = [
                .. corners.Select((p, i) => Add($"EDGE_CURVE('',{low[i]},{high[i]},{Line(At(p, bottom), At(p, top))},.T.)"))];
            (string Edge, bool IsBackward)[] ground = [.. loop.Select((c, i) => EdgeOf(c, i, i, bottom, low))];
            (string Edge, bool IsBackward)[] roof = [.. loop.Select((c, i) => EdgeOf(c, i, i + 1, top, high))];
            above.Add([.. roof.Select(e => Oriented(e.Edge, !e.IsBackward))]);
            below.Add([.. ground.Reverse().Select(e => Oriented(e.Edge, e.IsBackward))]);
            for (var i = 0; i < loop.Count; i++)
            {
                var next = (i + 1) % loop.Count;
                var surface = loop[i] is DrawnArc arc
                    ? Add($"CYLINDRICAL_SURFACE('',{Upright(At(arc.Center, bottom))},{Real(arc.Radius / unitMm)})")
                    : Plane(At(loop[i].From, bottom), Space(-loop[i].DirectionAtStart.Left) + new Vector3(0, 0, Slope));
                Face(
                    surface,
                    [
                        Oriented(ground[i].Edge, !ground[i].IsBackward), Oriented(up[next], true),
                        Oriented(roof[i].Edge, roof[i].IsBackward), Oriented(up[i], false),
                    ]);
            }
        }

        Face("", Plane(new(0, 0, top / unitMm), new(0, 0, 1)), [.. above]);
        Face("", Plane(new(0, 0, bottom / unitMm), new(0, 0, -1)), [.. below]);
        return this;

        Point3 At(Point2 p, double height) => new(p.X / unitMm, p.Y / unitMm, height / unitMm);

        string Upright(Point3 p) => Placement(p, new(0, 0, 1), new(1, 0, 0));

        static Vector3 Space(Vector2 v) => new(v.X, v.Y, 0);

        (string Edge, bool IsBackward) EdgeOf(DrawnCurve curve, int i, int style, double height, string[] vertices)
        {
            var (isBackward, isDown) = (style % 2 == 1, style % 4 >= 2);
            var (from, to) = (vertices[i], vertices[(i + 1) % vertices.Length]);
            var (geometry, isAlong) = curve switch
            {
                DrawnArc arc => (Circle(At(arc.Center, height), arc.Radius / unitMm, isDown ? -1 : 1), arc.Sweep > 0 != isDown),
                _ => (Line(At(curve.From, height), At(curve.To, height)), true),
            };
            return (
                Add($"EDGE_CURVE('',{(isBackward ? to : from)},{(isBackward ? from : to)},{geometry},{Flag(isAlong != isBackward)})"),
                isBackward);
        }
    }

    public string Text(string unit = Millimeter)
    {
        var shell = IsSolid
            ? Add($"MANIFOLD_SOLID_BREP('',{Add($"CLOSED_SHELL('',({string.Join(',', _faces)}))")})")
            : Add($"SHELL_BASED_SURFACE_MODEL('',({Add($"OPEN_SHELL('',({string.Join(',', _faces)}))")}))");
        var text = new StringBuilder(
            """
            ISO-10303-21;
            HEADER;FILE_DESCRIPTION((''),'2;1');FILE_NAME('a','',(''),(''),'','','');FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));ENDSEC;
            DATA;
            #1=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#2))REPRESENTATION_CONTEXT('',''));
            """.ReplaceLineEndings("\n"));
        text.Append(CultureInfo.InvariantCulture, $"\n#2={unit};\n#3=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n")
            .Append(CultureInfo.InvariantCulture, $"#4=SHAPE_REPRESENTATION('',({shell}),#1);\n");
        return text.AppendJoin('\n', _lines).Append("\nENDSEC;\nEND-ISO-10303-21;\n").ToString();
    }

    public byte[] Bytes(string unit = Millimeter) => Encoding.Latin1.GetBytes(Text(unit));

    public Drawing Read(double? unitMm = null) => StepDrawing.Read(Bytes(), "part.stp", unitMm);

    public InputException Refused() => Refused(Bytes());

    public static InputException Refused(byte[] bytes) =>
        Assert.Throws<InputException>(() => StepDrawing.Read(bytes, "part.stp", null));

    public static string Real(double value)
    {
        var text = value.ToString("R", CultureInfo.InvariantCulture);
        return text.Contains('.', StringComparison.Ordinal) ? text
            : text.Contains('E', StringComparison.Ordinal) ? text.Replace("E", ".E", StringComparison.Ordinal) : text + ".";
    }

    private static string Flag(bool value) => value ? ".T." : ".F.";
}
