using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Writes a surface as a STEP file (AP214, millimeters): one part with one face, bounded by its edges.</summary>
/// <remarks>The same surface gives the same bytes, because the date in the file is constant. Numbers round-trip exactly.</remarks>
public static class StepWriter
{
    // The format requires a date. It is constant, so that the same content gives the same file.
    private const string Date = "2000-01-01T00:00:00";

    /// <summary>Returns the file's bytes.</summary>
    /// <param name="surface">The surface with its boundaries, in millimeters.</param>
    public static byte[] Write(PartSurface surface)
    {
        ArgumentNullException.ThrowIfNull(surface);
        var name = StepText.Write(surface.Name);
        var lines = new StepLines();
        var application = lines.Add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        lines.Add($"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})");
        var product = lines.Add($"PRODUCT({name},{name},'',({lines.Add($"PRODUCT_CONTEXT('',{application},'mechanical')")}))");
        var formation = lines.Add($"PRODUCT_DEFINITION_FORMATION('','',{product})");
        var definition = lines.Add(
            $"PRODUCT_DEFINITION('design','',{formation},"
                + $"{lines.Add($"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")})");
        var shape = lines.Add($"PRODUCT_DEFINITION_SHAPE('','',{definition})");
        lines.Add($"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))");
        var length = lines.Add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
        var angle = lines.Add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        var solid = lines.Add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        var uncertainty = lines.Add(
            $"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),{length},'distance_accuracy_value','confusion accuracy')");
        var context = lines.Add(
            $"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty})"
                + $")GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))REPRESENTATION_CONTEXT('',''))");
        var face = Face(lines, surface, name);
        var model = lines.Add($"SHELL_BASED_SURFACE_MODEL('',({lines.Add($"OPEN_SHELL('',({face}))")}))");
        var origin = lines.Add(
            $"AXIS2_PLACEMENT_3D('',{lines.Point(new Point3(0, 0, 0))},{lines.Add("DIRECTION('',(0.,0.,1.))")},"
                + $"{lines.Add("DIRECTION('',(1.,0.,0.))")})");
        var representation = lines.Add($"MANIFOLD_SURFACE_SHAPE_REPRESENTATION({name},({origin},{model}),{context})");
        lines.Add($"SHAPE_DEFINITION_REPRESENTATION({shape},{representation})");
        return Encoding.ASCII.GetBytes(
            $"""
            ISO-10303-21;
            HEADER;
            FILE_DESCRIPTION((''),'2;1');
            FILE_NAME({name},'{Date}',(''),(''),'ErrorMatching','ErrorMatching','');
            FILE_SCHEMA(('AUTOMOTIVE_DESIGN {"{ 1 0 10303 214 1 1 1 1 }"}'));
            ENDSEC;
            DATA;
            {lines}ENDSEC;
            END-ISO-10303-21;

            """.ReplaceLineEndings("\n"));
    }

    private static string Face(StepLines lines, PartSurface surface, string name)
    {
        var spline = lines.Surface(surface.Spline, name);
        var edges = new StepEdges(lines, surface.Spline, spline);
        IReadOnlyList<IReadOnlyList<Point2>> loops = surface.Region.IsWhole ? [RegionLimits.Border(surface.Spline)] : surface.Region.Loops;
        var outer = loops.MaxBy(l => Math.Abs(RegionLoop.Area(l)));
        List<string> bounds = [];
        foreach (var loop in loops)
        {
            // The outer bound runs counterclockwise about the outward normal, holes clockwise.
            var isOuter = ReferenceEquals(loop, outer);
            var asItIs = ((RegionLoop.Area(loop) > 0) == isOuter) == (surface.Outside > 0);
            var edge = surface.Region.IsWhole ? edges.Border() : edges.Polygon(loop);
            bounds.Add(lines.Add($"{(isOuter ? "FACE_OUTER_BOUND" : "FACE_BOUND")}('',{edge},{(asItIs ? ".T." : ".F.")})"));
        }

        return lines.Add($"ADVANCED_FACE({name},({string.Join(',', bounds)}),{spline},{(surface.Outside > 0 ? ".T." : ".F.")})");
    }
}
