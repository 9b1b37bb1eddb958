using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Dimensions and tolerances of STEP files: what they mean, and that one that is broken spoils no other.</summary>
public sealed class ModelAnnotationTests
{
    // A square of 10 mm as a face, #100, on the plane #101. Annotations begin at #200; #150 and #151 are millimeters and inches.
    private const string Face =
        """
        #100=ADVANCED_FACE('',(#102),#101,.T.);
        #101=PLANE('',#103);
        #102=FACE_BOUND('',#104,.T.);
        #103=AXIS2_PLACEMENT_3D('',#111,$,$);
        #104=EDGE_LOOP('',(#120,#121,#122,#123));
        #111=CARTESIAN_POINT('',(0.,0.,0.));
        #112=CARTESIAN_POINT('',(10.,0.,0.));
        #113=CARTESIAN_POINT('',(10.,10.,0.));
        #114=CARTESIAN_POINT('',(0.,10.,0.));
        #115=VERTEX_POINT('',#111);
        #116=VERTEX_POINT('',#112);
        #117=VERTEX_POINT('',#113);
        #118=VERTEX_POINT('',#114);
        #120=ORIENTED_EDGE('',*,*,#130,.T.);
        #121=ORIENTED_EDGE('',*,*,#131,.T.);
        #122=ORIENTED_EDGE('',*,*,#132,.T.);
        #123=ORIENTED_EDGE('',*,*,#133,.T.);
        #130=EDGE_CURVE('',#115,#116,#140,.T.);
        #131=EDGE_CURVE('',#116,#117,#141,.T.);
        #132=EDGE_CURVE('',#117,#118,#142,.T.);
        #133=EDGE_CURVE('',#118,#115,#143,.T.);
        #140=LINE('',#111,#144);
        #141=LINE('',#112,#145);
        #142=LINE('',#113,#146);
        #143=LINE('',#114,#147);
        #144=VECTOR('',#148,1.);
        #145=VECTOR('',#149,1.);
        #146=VECTOR('',#148,1.);
        #147=VECTOR('',#149,1.);
        #148=DIRECTION('',(1.,0.,0.));
        #149=DIRECTION('',(0.,1.,0.));
        #150=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
        #151=(CONVERSION_BASED_UNIT('INCH',#152)LENGTH_UNIT()NAMED_UNIT(#153));
        #152=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#150);
        #153=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);
        #160=SHAPE_ASPECT('','',#199,.T.);
        #161=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#160,#10,#100);
        #162=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.2),#150);
        #163=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(POSITIVE_LENGTH_MEASURE(2.),#151)
        REPRESENTATION_ITEM('nominal value'));
        #164=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(-0.01),#151);
        #165=DATUM('','',#199,.F.,'A');
        #166=DATUM('','',#199,.F.,'B');
        #199=PRODUCT_DEFINITION_SHAPE('','',$);

        """;

    [Fact]
    public void A_tolerance_has_its_kind_its_value_its_datums_and_its_faces()
    {
        var found = One(
            """
            #200=(GEOMETRIC_TOLERANCE('Profile.1','',#162,#160)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#201))
            GEOMETRIC_TOLERANCE_WITH_MODIFIERS((.MAXIMUM_MATERIAL_REQUIREMENT.,.FREE_STATE.))LINE_PROFILE_TOLERANCE()
            UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE(#164));
            #201=DATUM_SYSTEM('','',#199,.F.,(#202,#203));
            #202=DATUM_REFERENCE_COMPARTMENT('','',#199,.F.,#165,$);
            #203=DATUM_REFERENCE_COMPARTMENT('','',#199,.F.,COMMON_DATUM_LIST((#204,#205)),$);
            #204=DATUM_REFERENCE_ELEMENT('','',#199,.F.,#166,$);
            #205=DATUM_REFERENCE_ELEMENT('','',#199,.F.,#165,$);
            """);
        Assert.Null(found.Problem);
        Assert.Equal(("Profile.1", "line-profile", "#200 LINE_PROFILE_TOLERANCE"), (found.Name, found.Kind, found.Entity));
        Assert.Equal((0.2, 1.0), (found.Value!.Value, found.UnitMm!.Value));
        Assert.Equal(-0.254, found.DisplacementMm!.Value, 1e-12);
        Assert.Equal(["A", "B-A"], found.Datums);
        Assert.Equal(["MAXIMUM_MATERIAL_REQUIREMENT", "FREE_STATE"], found.Modifiers);
        Assert.Equal([100], found.Faces);
        Assert.Equal(LineOf("#200="), found.Line);
        Assert.False(found.IsDimension);
    }

    [Theory]
    [InlineData("FLATNESS_TOLERANCE('F','',#162,#160)", "flatness", "")]
    [InlineData("PERPENDICULARITY_TOLERANCE('F','',#162,#160,(#165,#166))", "perpendicularity", "A|B")]
    [InlineData("POSITION_TOLERANCE('F','',#162,#160)", "position", "")]
    [InlineData("CIRCULAR_RUNOUT_TOLERANCE('F','',#162,#160,(#201))", "circular-runout", "?")]
    [InlineData("GEOMETRIC_TOLERANCE('F','',#162,#160)", "tolerance", "")]
    public void A_simple_instance_has_all_attributes_in_one_list(string text, string kind, string datums)
    {
        var found = One($"#200={text};\n#201=PRODUCT();");
        Assert.Equal((kind, "F", 0.2), (found.Kind, found.Name, found.Value!.Value));
        Assert.Equal(datums, string.Join('|', found.Datums));
        Assert.Equal([100], found.Faces);
    }

    [Fact]
    public void A_dimension_has_its_nominal_and_its_limits_in_millimeters_and_the_name_of_its_callout()
    {
        var found = One(
            """
            #200=DIMENSIONAL_SIZE(#160,'diameter');
            #201=SHAPE_DIMENSION_REPRESENTATION('',(#163),#1);
            #202=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#200,#201);
            #203=PLUS_MINUS_TOLERANCE(#204,#200);
            #204=TOLERANCE_VALUE(#164,#162);
            #205=DRAUGHTING_CALLOUT('Linear Size.1',());
            #206=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#200,$,#205);
            """);
        Assert.Equal(("Linear Size.1", ModelAnnotation.Size, "diameter"), (found.Name, found.Kind, found.Quantity));
        Assert.True(found.IsDimension);
        Assert.Equal(50.8, found.Value!.Value, 1e-12);
        Assert.Equal((-0.254, 0.2), (Math.Round(found.Limits!.Value.Lower, 9), found.Limits.Value.Upper));
        Assert.Equal([100], found.Faces);
    }

    [Fact]
    public void Limits_may_be_stated_as_two_sizes_and_an_angle_is_in_degrees()
    {
        var range = One(
            """
            #200=DIMENSIONAL_SIZE(#160,'diameter');
            #201=SHAPE_DIMENSION_REPRESENTATION('',(#203,#204),#1);
            #202=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#200,#201);
            #203=MEASURE_REPRESENTATION_ITEM('upper limit',LENGTH_MEASURE(10.1),#150);
            #204=MEASURE_REPRESENTATION_ITEM('lower limit',LENGTH_MEASURE(9.9),#150);
            """);
        Assert.Equal(10, range.Value!.Value, 1e-12);
        Assert.Equal((-0.1, 0.1), (Math.Round(range.Limits!.Value.Lower, 9), Math.Round(range.Limits.Value.Upper, 9)));
        var angle = One(
            """
            #200=ANGULAR_LOCATION('','',#160,#160,.SMALL.);
            #201=SHAPE_DIMENSION_REPRESENTATION('',(#203),#1);
            #202=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#200,#201);
            #203=MEASURE_REPRESENTATION_ITEM('nominal value',PLANE_ANGLE_MEASURE(60.),#205);
            #205=(CONVERSION_BASED_UNIT('DEGREE',#206)NAMED_UNIT(*)PLANE_ANGLE_UNIT());
            #206=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#207);
            #207=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
            """);
        Assert.Equal(ModelAnnotation.Angle, angle.Kind);
        Assert.Equal(60, angle.Value!.Value, 1e-9);
        Assert.Null(angle.UnitMm);
    }

    [Fact]
    public void A_size_that_is_a_datum_feature_is_of_itself()
    {
        var found = One(
            """
            #200=DIMENSIONAL_SIZE_WITH_DATUM_FEATURE('','',#199,.T.,#200,'diameter');
            #201=SHAPE_DIMENSION_REPRESENTATION('',(#163),#1);
            #202=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#200,#201);
            #203=ITEM_IDENTIFIED_REPRESENTATION_USAGE('',$,#200,#10,SET_REPRESENTATION_ITEM((#100)));
            """);
        Assert.Null(found.Problem);
        Assert.Equal("diameter", found.Quantity);
        Assert.Equal([100], found.Faces);
    }

    [Fact]
    public void Composite_aspects_are_their_parts_and_what_is_no_face_is_named()
    {
        var found = One(
            """
            #200=SURFACE_PROFILE_TOLERANCE('','',#162,#201);
            #201=ALL_AROUND_SHAPE_ASPECT('','',#199,.F.);
            #202=SHAPE_ASPECT_RELATIONSHIP('','',#201,#203);
            #203=COMPOSITE_SHAPE_ASPECT('','',#199,.F.);
            #204=SHAPE_ASPECT_RELATIONSHIP('','',#203,#160);
            #205=SHAPE_ASPECT_RELATIONSHIP('','',#203,#206);
            #206=SHAPE_ASPECT('','',#199,.T.);
            #207=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#206,#10,#130);
            #208=SHAPE_ASPECT_RELATIONSHIP('','',#203,#165);
            #209=SHAPE_ASPECT('','',#199,.T.);
            #210=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#209,#10,#131);
            #211=SHAPE_ASPECT_RELATIONSHIP('','',#165,#209);
            """);

        // Nothing of a datum, whatever it is related to.
        Assert.Equal([100], found.Faces);
        Assert.Equal(["#130 EDGE_CURVE"], found.Others);
        var whole = One("#200=SURFACE_PROFILE_TOLERANCE('','',#162,#199);");
        Assert.True(whole.IsAllOver);
    }

    [Theory]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',$,#160);", "#200 FLATNESS_TOLERANCE: a tolerance without a magnitude (line L)")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#201,#160);\n#201=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(-1.),#150);",
        "a magnitude of -1 mm; none below zero")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#201,#160);\n#201=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE('x'),#150);",
        "#201 LENGTH_MEASURE_WITH_UNIT: attribute 1 is not a number (line M)")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#201,#160);\n#201=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.2.3),#150);",
        "\"1.2.3\" where a number is expected (line M)")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#201,#160);\n#201=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E300),#150);",
        "larger than any dimension")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#201,#160);\n#201=LENGTH_MEASURE_WITH_UNIT(MASS_MEASURE(1.),#150);",
        "a length or an angle")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#201,#160);\n#201=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.),#165);", "no LENGTH_UNIT")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#777,#160);", "refers to #777, which the file does not have")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#162,#201);\n#201=SHAPE_ASPECT('','',$,.T.);\n"
        + "#202=SHAPE_ASPECT_RELATIONSHIP('','',#201,#203);\n#203=SHAPE_ASPECT('','',$,.T.);\n"
        + "#204=SHAPE_ASPECT_RELATIONSHIP('','',#203,#201);", "made of itself (line M)")]
    [InlineData("#200=FLATNESS_TOLERANCE('F','',#200,#160);", "a measure with a unit is expected")]
    [InlineData("#200=DIMENSIONAL_SIZE(#160,'diameter');", "it has no value")]
    [InlineData("#200=DIMENSIONAL_SIZE(#160,'d');\n#201=SHAPE_DIMENSION_REPRESENTATION('',(#163),#1);\n"
        + "#202=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#200,#201);\n#203=PLUS_MINUS_TOLERANCE(#204,#200);\n"
        + "#204=TOLERANCE_VALUE(#162,#164);", "its lower limit 0.2 is above its upper one -0.254")]
    [InlineData("#200=DIMENSIONAL_SIZE(#160,'d');\n#201=SHAPE_DIMENSION_REPRESENTATION('',(#163),#1);\n"
        + "#202=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#200,#201);\n#203=PLUS_MINUS_TOLERANCE(#205,#200);\n"
        + "#204=PLUS_MINUS_TOLERANCE(#205,#200);\n#205=TOLERANCE_VALUE(#162,#162);", "2 PLUS_MINUS_TOLERANCE")]
    public void A_broken_one_says_why_and_where_and_the_others_are_read(string broken, string problem)
    {
        var text = broken + "\n#300=FLATNESS_TOLERANCE('Whole','',#162,#160);";
        var line = LineOf("#200=");
        problem = problem.Replace("(line L)", string.Create(CultureInfo.InvariantCulture, $"(line {line})"), StringComparison.Ordinal)
            .Replace("(line M)", string.Create(CultureInfo.InvariantCulture, $"(line {line + 1})"), StringComparison.Ordinal);
        var found = Read(text).Annotations;
        Assert.Equal([200, 300], found.Select(a => a.Number));
        Assert.Contains(problem, found[0].Problem, StringComparison.Ordinal);
        Assert.Equal((0.2, null), (found[1].Value, found[1].Problem));
    }

    [Fact]
    public void Aspects_that_go_on_for_ever_are_told()
    {
        var text = new StringBuilder("#200=FLATNESS_TOLERANCE('F','',#162,#1000);\n");
        for (var i = 1000; i < 1100; i++)
        {
            text.Append(CultureInfo.InvariantCulture, $"#{i}=SHAPE_ASPECT('','',$,.T.);\n");
            text.Append(CultureInfo.InvariantCulture, $"#{i + 1000}=SHAPE_ASPECT_RELATIONSHIP('','',#{i},#{i + 1});\n");
        }

        Assert.Contains("deeper than 32", One(text.ToString()).Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Pictures_of_annotations_are_no_assembly_and_a_moved_part_is_one()
    {
        const string Item = "#200=MAPPED_ITEM('',#201,#204);\n#201=REPRESENTATION_MAP(#202,#10);\n#204=AXIS2_PLACEMENT_3D('',#112,$,$);\n";
        Assert.Single(Read(Item + "#202=CAMERA_MODEL_D3('',#103,$);").Faces);
        Assert.Single(Read(Item.Replace("#204=AXIS2_PLACEMENT_3D('',#112", "#204=AXIS2_PLACEMENT_3D('',#111", StringComparison.Ordinal)
            + "#202=AXIS2_PLACEMENT_3D('',#111,$,$);").Faces);
        Assert.Equal("assembly", Assert.Throws<InputException>(() => Read(Item + "#202=AXIS2_PLACEMENT_3D('',#111,$,$);")).Code);
    }

    [Theory]
    [InlineData("PLANE", true, 0, 0, 1)]
    [InlineData("PLANE", false, 0, 0, -1)]
    [InlineData("CYLINDRICAL_SURFACE", true, 3, 4, 0)]
    [InlineData("CYLINDRICAL_SURFACE", false, -3, -4, 0)]
    public void The_side_of_the_material_is_that_of_the_face_not_of_its_surface(
        string surface, bool isAlong, double x, double y, double z)
    {
        var face = new WallFace(1, surface) { Axis = new(0, 0, 1), Origin = new(1, 1, 1), IsOfSolid = true, IsAlongSurface = isAlong };
        Assert.Equal(new Geometry.Vector3(x, y, z), face.OutwardAt(new(4, 5, 6)));
        Assert.Null((face with { IsOfSolid = false }).OutwardAt(new(4, 5, 6)));
    }

    [Fact]
    public void An_edge_leads_to_the_faces_that_meet_in_it()
    {
        var model = Read("");
        var edges = model.Faces[0].ReadBounds()[0];
        Assert.Equal([130L, 131, 132, 133], edges.Select(e => e.Number));
        Assert.Equal([100L], model.FacesAt(130).Select(f => f.Number));
        Assert.Empty(model.FacesAt(140));
    }

    [Fact]
    public void Damaged_ones_are_read_or_refused()
    {
        var file = File(
            """
            #200=(GEOMETRIC_TOLERANCE('P','',#162,#210)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#201))SURFACE_PROFILE_TOLERANCE());
            #201=DATUM_SYSTEM('','',#199,.F.,(#202));
            #202=DATUM_REFERENCE_COMPARTMENT('','',#199,.F.,#165,$);
            #203=DIMENSIONAL_SIZE(#160,'diameter');
            #204=SHAPE_DIMENSION_REPRESENTATION('',(#163),#1);
            #205=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#203,#204);
            #206=PLUS_MINUS_TOLERANCE(#207,#203);
            #207=TOLERANCE_VALUE(#164,#162);
            #208=TOLERANCE_ZONE('','',#199,.F.,(#200),#209);
            #209=TOLERANCE_ZONE_FORM('');
            #210=COMPOSITE_SHAPE_ASPECT('','',#199,.F.);
            #211=SHAPE_ASPECT_RELATIONSHIP('','',#210,#160);
            """);
        var random = new Random(1);
        var (read, told) = (0, 0);
        for (var n = 0; n < 600; n++)
        {
            try
            {
                var model = FlatFaces.Read(Damaged.Of(file, random), "a.stp");
                read += model.Annotations.Count(a => a.Problem is null);
                told += model.Annotations.Count(a => a.Problem is not null);
                Assert.All(model.Annotations, a => Assert.True(a.Problem is not null || !(a.Value is { } v && !double.IsFinite(v))));
            }
            catch (InputException e)
            {
                Assert.InRange(e.Message.Length, 1, 2_000);
            }
        }

        Assert.InRange(read, 300, 1200);
        Assert.InRange(told, 20, 1200);
    }

    [Fact]
    public void Time_grows_with_the_number_of_annotations()
    {
        var head = Encoding.Latin1.GetString(File(""));
        var end = head.IndexOf("ENDSEC;\nEND-ISO", StringComparison.Ordinal);
        var (start, tail) = (head[..end], head[end..]);
        ReadingCost.IsLinear(
            1 << 17,
            bytes =>
            {
                try
                {
                    Assert.NotNull(FlatFaces.Read(bytes, "a.stp"));
                }
                catch (InputException e)
                {
                    Assert.InRange(e.Message.Length, 1, 2_000);
                }
            },
            (start, "#7§=FLATNESS_TOLERANCE('',$,#162,#160);\n", tail),
            (start, "#7§=(GEOMETRIC_TOLERANCE('',$,#162,#160)POSITION_TOLERANCE());\n", tail),
            (start, "#7§=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#160,#10,#100);\n", "#200=FLATNESS_TOLERANCE('',$,#162,#160);\n" + tail),
            (start, "#7§=SHAPE_ASPECT_RELATIONSHIP('','',#160,#160);\n", "#200=FLATNESS_TOLERANCE('',$,#162,#160);\n" + tail),
            (start, "#7§=DIMENSIONAL_LOCATION('',$,#160,#160);\n", tail),
            (start, "#7§=PLUS_MINUS_TOLERANCE(#162,#200);\n", "#200=DIMENSIONAL_SIZE(#160,'');\n" + tail),
            (start, "#7§=TOLERANCE_ZONE('','',$,.F.,(#200),$);\n", "#200=FLATNESS_TOLERANCE('',$,#162,#160);\n" + tail));
    }

    private static byte[] File(string annotations) =>
        StepByHand.File("#101,#100", Face + annotations.ReplaceLineEndings("\n"));

    private static FlatFaces Read(string annotations) => FlatFaces.Read(File(annotations), "hand.stp");

    private static ModelAnnotation One(string annotations) => Assert.Single(Read(annotations).Annotations);

    private static int LineOf(string start) =>
        1 + Encoding.Latin1.GetString(File("#200=X();"))[..Encoding.Latin1.GetString(File("#200=X();"))
            .IndexOf(start, StringComparison.Ordinal)].Count(c => c == '\n');
}
