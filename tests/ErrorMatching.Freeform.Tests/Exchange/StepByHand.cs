using System.Text;

namespace ErrorMatching.Freeform.Tests;

/// <summary>STEP files put together by hand around the instances of a test, which begin at #100; #1 is the context with its unit.</summary>
internal static class StepByHand
{
    public const string Millimeter = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))";

    /// <summary>A unit of length as an inch, by its definition in millimeters (#3).</summary>
    public const string Inch = "(CONVERSION_BASED_UNIT('INCH',#4)LENGTH_UNIT()NAMED_UNIT(#5));\n#3=(LENGTH_UNIT()NAMED_UNIT(*)"
        + "SI_UNIT(.MILLI.,.METRE.));\n#4=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#3);\n#5=DIMENSIONAL_EXPONENTS(1.,0.,0.,"
        + "0.,0.,0.,0.)";

    /// <summary>The bytes of a file.</summary>
    /// <param name="items">What the representation holds, such as #100,#200.</param>
    /// <param name="data">The instances.</param>
    /// <param name="unit">The unit of length.</param>
    public static byte[] File(string items, string data, string unit = Millimeter) => Encoding.Latin1.GetBytes(
        $"""
        ISO-10303-21;
        HEADER;
        FILE_DESCRIPTION(('; #9=NONE('),'2;1');
        FILE_NAME('a','2026-01-01T00:00:00',(''),(''),'','','');
        FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));
        ENDSEC;
        DATA;
        #1=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#2))REPRESENTATION_CONTEXT('',''));
        #2={unit};
        #10=SHAPE_REPRESENTATION('',({items}),#1);
        {data}
        ENDSEC;
        END-ISO-10303-21;
        """);

    /// <summary>Reads a file.</summary>
    public static PartSurface Read(byte[] file, string? entity = null, bool outsideIsUp = true) =>
        SurfaceReader.Read(file, "hand.stp", entity, outsideIsUp);

    /// <summary>Numbered points, one a line.</summary>
    /// <param name="first">Number of the first one.</param>
    /// <param name="points">Their coordinates as text.</param>
    public static string Points(int first, params string[] points) =>
        string.Join('\n', points.Select((p, i) => $"#{first + i}=CARTESIAN_POINT('',({p}));"));

    /// <summary>An edge of straight lines between points, with its vertices:
    /// #n for the oriented edge, #n+1 to #n+5 for what it is made of.</summary>
    public static string Line(int n, int from, int to, bool forward = true) =>
        $"""
        #{n}=ORIENTED_EDGE('',*,*,#{n + 1},{(forward ? ".T." : ".F.")});
        #{n + 1}=EDGE_CURVE('',#{n + 2},#{n + 3},#{n + 4},.T.);
        #{n + 2}=VERTEX_POINT('',#{(forward ? from : to)});
        #{n + 3}=VERTEX_POINT('',#{(forward ? to : from)});
        #{n + 4}=LINE('',#{from},#{n + 5});
        #{n + 5}=VECTOR('',#9999,1.);
        """;
}
