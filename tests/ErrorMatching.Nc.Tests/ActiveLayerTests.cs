using System.Text.RegularExpressions;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Whatever changes an active offset, frame or length makes the tool's place follow or unknown. The codes come from the
/// dialects themselves, so that a new entry is tested as soon as it is there; what each meaning does to the place is worked out here, by
/// hand.</summary>
public sealed class ActiveLayerTests
{
    private const AxisSet None = AxisSet.None;
    private static readonly Point3 Place = new(20, 10, 5);

    /// <summary>Every code and word of every dialect, with its meaning.</summary>
    public static TheoryData<string, string, NcMeaning> Entries
    {
        get
        {
            var entries = new TheoryData<string, string, NcMeaning>();
            foreach (var dialect in NcDialects.All)
            {
                foreach (var fact in dialect.Facts.Where(f => f.Topic == DialectTopic.Code))
                {
                    var subjects = new List<SubjectRange>();
                    Assert.True(SubjectRange.TryRead(fact.Subject, DialectTopic.Code, subjects, out _));
                    foreach (var subject in subjects)
                    {
                        // A range means the same throughout.
                        var meaning = subject is { HasNumbers: true, Word: "G" } ? dialect.MeaningOf(subject.First)
                            : dialect.MeaningOf(System.Text.Encoding.ASCII.GetBytes(subject.Names().First()));
                        if (Effect(meaning) != Layer.Nothing)
                        {
                            entries.Add(dialect.Name, subject.Spelling.Split("..")[0], meaning);
                        }
                    }
                }
            }

            return entries;
        }
    }

    [Theory]
    [MemberData(nameof(Entries))]
    public void What_changes_an_active_layer_moves_the_place_along(string dialect, string code, NcMeaning meaning)
    {
        var control = NcDialects.Named(dialect);
        var before = Before(control, meaning);
        var path = Bench.Read($"{Head(control)}\n{before}{Block(control, code, meaning)}\n{Step(control)}\n", control);
        var last = path.Motions[^1];

        Assert.Equal(path.Program.BlockCount - 1, path.Motions.BlockOf(path.Motions.Length - 1));
        var (expected, unknown) = Expected(control, code, meaning);
        Assert.Equal(unknown, unknown & last.UnknownStart);
        foreach (var axis in (AxisSet[])[AxisSet.X, AxisSet.Y, AxisSet.Z])
        {
            if ((last.UnknownStart & axis) == None)
            {
                Assert.Equal(0, axis.PartOf(expected - last.Start).Length, 9);
            }
        }
    }

    [Theory]

    // The place gets the coordinates that the block gives (rs274; grbl's source: WCS = MPos - G92 - TLO - WPos).
    [InlineData("linuxcnc", "G10 L20 P1 X0 Y0", "0,0,5")]
    [InlineData("linuxcnc", "G10 L20 P0 X0 Y0", "0,0,5")]
    [InlineData("linuxcnc", "G55\nG0 X20 Y10 Z5\nG10 L20 P2 X0 Y0", "0,0,5")]
    [InlineData("grbl", "G10 L20 P1 X0 Y0", "0,0,5")]
    [InlineData("grbl", "G10 L20 P0 X0 Y0", "0,0,5")]
    [InlineData("grbl", "G55\nG0 X20 Y10 Z5\nG10 L20 P2 X0 Y0", "0,0,5")]
    [InlineData("grbl", "G10 L20 P2 X0 Y0", "20,10,5")]
    [InlineData("grbl", "G10 L2 P2 X0 Y0", "20,10,5")]
    [InlineData("grbl", "G10 L2 P1 X0 Y0", "?,?,5")]
    [InlineData("grbl", "G10 L2 P0 X0 Y0", "?,?,5")]

    // Increments of an origin are positions all the same (grbl, rs274): what it was before is not known.
    [InlineData("grbl", "G91\nG10 L2 P1 X1", "?,10,5")]
    [InlineData("linuxcnc", "G91\nG10 L2 P1 X1 R0", "?,?,5")]
    [InlineData("generic", "G91\nG10 L2 P1 X1", "?,?,?")]
    [InlineData("fanuc", "G91\nG10 L2 P1 X1.", "19,10,5")]
    [InlineData("haas", "G91\nG10 L2 P1 X1.", "19,10,5")]
    [InlineData("generic", "G10 L20 P1 X0 Y0", "0,0,5")]
    [InlineData("generic", "G54.1 P1\nG0 X20 Y10 Z5\nG10 L20 P1 X0 Y0", "?,?,?")]

    // A further offset has several names.
    [InlineData("haas", "G154 P1\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "?,?,5")]
    [InlineData("haas", "G154 P1\nG0 X20. Y10. Z5.\nG91 G10 L20 P1 X1.", "19,10,5")]
    [InlineData("haas", "G54.1 P1\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "?,?,?")]
    [InlineData("haas", "G110\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "?,?,5")]
    [InlineData("haas", "G111\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "20,10,5")]
    [InlineData("haas", "G10 L20 P1 X0. Y0.", "20,10,5")]
    [InlineData("fanuc", "G54.1 P1\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "?,?,5")]
    [InlineData("fanuc", "G54 P1\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "?,?,5")]
    [InlineData("fanuc", "G54 P1\nG0 X20. Y10. Z5.\nG10 L2 P1 X0. Y0.", "20,10,5")]
    [InlineData("fanuc", "G10 L20 P1 X0. Y0.", "20,10,5")]
    [InlineData("mazak-eia", "G54.1 P1\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "?,?,5")]

    // Which offset is active, or written, is not known.
    [InlineData("fanuc", "G54.1 P#500\nG0 X20. Y10. Z5.\nG10 L20 P1 X0. Y0.", "?,?,?")]
    [InlineData("fanuc", "G65 P9815\nG90 G0 X20. Y10. Z5.\nG10 L2 P2 X0. Y0.", "?,?,?")]
    [InlineData("fanuc", "G10 L2 P#500 X0. Y0.", "?,?,?")]
    [InlineData("fanuc", "G10 L2 P0 X0. Y0.", "?,?,?")]
    [InlineData("fanuc", "G10 X0. Y0.", "?,?,?")]
    [InlineData("fanuc", "G10 L50", "?,?,?")]
    [InlineData("haas", "G10 L2 P0 X0. Y0.", "?,?,?")]

    // The length in force.
    [InlineData("fanuc", "G43 H1", "20,10,?")]
    [InlineData("fanuc", "G43 H1\nZ5.\nH2", "20,10,?")]
    [InlineData("fanuc", "G43 H1\nZ5.\nG49", "20,10,?")]
    [InlineData("fanuc", "G49", "20,10,5")]
    [InlineData("fanuc", "G43 H1\nZ5.\nG10 L10 P1 R50.", "20,10,?")]
    [InlineData("fanuc", "G43 H1\nZ5.\nG10 L11 P1 R.1", "20,10,?")]
    [InlineData("fanuc", "G65 P9815\nG90 G0 X20. Y10. Z5.\nG49", "?,?,?")]
    [InlineData("linuxcnc", "G43 H1\nZ5\nG10 L1 P1 Z50", "20,10,?")]
    [InlineData("linuxcnc", "G43.1 Z3", "20,10,2")]
    [InlineData("linuxcnc", "G43.1 Z3\nG49", "20,10,5")]
    [InlineData("grbl", "G43.1 Z3\nG49", "20,10,5")]
    [InlineData("okuma-osp", "G56 H1", "20,10,?")]
    [InlineData("siemens-840d", "T2", "20,10,?")]
    [InlineData("siemens-840d", "D2", "20,10,?")]
    [InlineData("siemens-840d", "T=\"MILL_10\"", "20,10,?")]
    [InlineData("siemens-840d", "$TC_DP3[1,1]=55", "20,10,?")]
    [InlineData("siemens-840d", "$TC_DP12[1,1]=0.2", "20,10,?")]
    [InlineData("siemens-840d", "$TC_DP6[1,1]=5", "20,10,5")]

    // Variables of the control.
    [InlineData("fanuc", "#5221=5.", "?,?,?")]
    [InlineData("fanuc", "#[5221+#1]=5.", "?,?,?")]
    [InlineData("haas", "#5221=5.", "?,?,?")]
    [InlineData("fanuc", "#11001=5.", "?,?,?")]
    [InlineData("linuxcnc", "#5221=5", "?,?,?")]
    [InlineData("linuxcnc", "#5220=2", "?,?,?")]
    [InlineData("linuxcnc", "#5211=2", "?,?,?")]
    [InlineData("siemens-840d", "$P_UIFR[1,X,TR]=5", "?,?,?")]
    [InlineData("siemens-840d", "$P_PFRAME=CTRANS(X,5)", "?,?,?")]
    [InlineData("okuma-osp", "VZOFX[1]=5", "?,?,?")]

    // Transformations that something unseen could have begun.
    [InlineData("fanuc", "G65 P9815\nG90 G0 X20. Y10. Z5.\nG69", "?,?,?")]
    [InlineData("siemens-840d", "TRANS X1 Y2\nTRANS", "20,10,5")]
    [InlineData("siemens-840d", "G500", "20,10,5")]
    [InlineData("siemens-840d", "G54", "?,?,?")]
    public void Cases(string dialect, string blocks, string place)
    {
        var control = NcDialects.Named(dialect);
        var path = Bench.Read($"{Head(control)}\n{blocks}\n{Step(control)}\n", control);
        Assert.Equal(place, Moves.At(path.Motions[^1].Start, path.Motions[^1].UnknownStart));
    }

    [Theory]
    [InlineData("CYCL DEF 7.1 X+3", "17,10,5")]
    [InlineData("CYCL DEF 7.1 X+3\nCYCL DEF 7.2 Y+1", "17,9,5")]
    [InlineData("CYCL DEF 7.1 X+3\nCYCL DEF 7.1 X+0", "20,10,5")]
    [InlineData("CYCL DEF 7.1 #5", "?,?,?")]
    [InlineData("CYCL DEF 247 PRESET ~\nQ339=+1", "?,?,?")]
    [InlineData("TRANS DATUM AXIS X+3", "?,?,?")]
    [InlineData("PRESET SELECT #1", "?,?,?")]
    [InlineData("TOOL CALL 2 Z S1000", "?,?,?")]
    [InlineData("FN 17: SYSWRITE ID 530 NR1 IDX1 = +5", "?,?,?")]
    public void Klartext(string blocks, string place)
    {
        var control = NcDialects.HeidenhainKlartext;
        var path = Bench.Read($"{Head(control)}\n{blocks}\n{Step(control)}\n", control);
        var last = path.Motions[^1];

        // A datum shift is a frame: the tool's programmed place is one less than the end of its step, and less the frame.
        var frame = path.Frames[last.Frame].ProgramShift;
        Assert.Equal(place, Moves.At(default(Point3) + (last.Start - (default(Point3) + frame)), last.UnknownStart));
    }

    private enum Layer
    {
        Nothing,
        Origin,
        Given,
        Shift,
        ShiftBack,
        Write,
        Length,
        LengthOff,
        LengthGiven,
        Transform,
        TransformOff,
        Opaque,
    }

    // A new meaning is none of these until somebody has thought about it.
    private static Layer Effect(NcMeaning meaning) => meaning switch
    {
        NcMeaning.WorkOffset or NcMeaning.UnknownOrigin => Layer.Origin,
        NcMeaning.SetPosition => Layer.Given,
        NcMeaning.LocalShift => Layer.Shift,
        NcMeaning.ClearPosition or NcMeaning.SuspendPosition or NcMeaning.RestorePosition => Layer.ShiftBack,
        NcMeaning.SetOffset => Layer.Write,
        NcMeaning.LengthOffset => Layer.Length,
        NcMeaning.LengthOffsetOff => Layer.LengthOff,
        NcMeaning.ToolLength => Layer.LengthGiven,
        NcMeaning.Rotation or NcMeaning.Scaling or NcMeaning.Mirroring or NcMeaning.Polar or NcMeaning.FrameShift
            or NcMeaning.FrameShiftMore or NcMeaning.FrameRotation or NcMeaning.FrameRotationMore or NcMeaning.FrameScale
            or NcMeaning.FrameScaleMore or NcMeaning.FrameMirror or NcMeaning.FrameMirrorMore or NcMeaning.DatumShift => Layer.Transform,
        NcMeaning.RotationOff or NcMeaning.ScalingOff or NcMeaning.MirroringOff or NcMeaning.PolarOff
            or NcMeaning.OpaqueTransformOff => Layer.TransformOff,
        NcMeaning.OpaqueTransform or NcMeaning.Unsure => Layer.Opaque,

        // Modes, motions, cycles, calls, poles, corners, compensation and tool calls, which other tests have.
        NcMeaning.Unknown or NcMeaning.Harmless or (>= NcMeaning.Rapid and <= NcMeaning.CompensationRight)
            or (>= NcMeaning.ReferenceReturn and <= NcMeaning.SuppressFrames)
            or (>= NcMeaning.DrillCycle and <= NcMeaning.OpaqueMotion) or (>= NcMeaning.BoltCircle and <= NcMeaning.CornerChamfer)
            or (>= NcMeaning.ToolAxisRetract and <= NcMeaning.MeasuringCycle) => Layer.Nothing,
        _ => throw new InvalidOperationException($"Say here whether {meaning} changes a layer between program and machine."),
    };

    private static (Point3 Place, AxisSet Unknown) Expected(NcDialect control, string code, NcMeaning meaning) => Effect(meaning) switch
    {
        // The first of them is the one that is active where no block says another.
        Layer.Origin when code == (control.Syntax == NcSyntax.Siemens ? "G500" : "G54") => (Place, None),
        Layer.Origin or Layer.Opaque => (Place, AxisSet.All),
        Layer.Given => (new(1, 2, 3), None),
        Layer.Shift => (new(19, 8, 2), None),
        Layer.ShiftBack when meaning == NcMeaning.RestorePosition => (new(1, 2, 3), None),
        Layer.ShiftBack => (Place, None),
        Layer.Write => (Place, AxisSet.X | AxisSet.Y),
        Layer.LengthOff when control.MeaningOf(431) == NcMeaning.ToolLength && control.MeaningOf(430) == NcMeaning.Unknown => (Place, None),
        Layer.Length or Layer.LengthOff => (Place, AxisSet.Z),
        Layer.LengthGiven => (new(20, 10, 2), None),

        // Motions are in the coordinates of the work offset, where a transformation moves nothing.
        _ => (Place, None),
    };

    private static string Before(NcDialect control, NcMeaning meaning) => Effect(meaning) switch
    {
        Layer.ShiftBack when meaning == NcMeaning.RestorePosition => "G92 X1. Y2. Z3.\nG92.2\n",
        Layer.ShiftBack => "G92 X1. Y2. Z3.\n",
        Layer.LengthOff when control.MeaningOf(560) == NcMeaning.LengthOffset => "G56 H1\nZ5.\n",
        Layer.LengthOff when control.MeaningOf(430) == NcMeaning.LengthOffset => "G43 H1\nZ5.\n",
        Layer.LengthOff => "G43.1 Z0\n",
        _ => "",
    };

    private static string Head(NcDialect control) => control.HasCodes ? "G90 G17 G40 G0 X20. Y10. Z5." : "L X+20 Y+10 Z+5 R0 FMAX";

    private static string Step(NcDialect control) => control.HasCodes ? "G91 G1 X1. Y1. Z1. F100." : "L IX+1 IY+1 IZ+1 F100";

    private static string Block(NcDialect control, string code, NcMeaning meaning) => Effect(meaning) switch
    {
        _ when !control.HasCodes => Spelled(code),
        Layer.Origin when control.WorkOffsetLetter == 'H' => code + " H2",
        Layer.Origin => code == "G54" ? code : code + " P7",
        Layer.Given or Layer.Shift => code + " X1. Y2. Z3.",
        Layer.Write => code + " L2 P1 X1. Y2. Z3.",
        Layer.Length => code + " H1",
        Layer.LengthGiven => code + " Z3.",
        Layer.Transform when meaning == NcMeaning.Rotation => code + " X0. Y0. R30.",
        Layer.Transform when meaning == NcMeaning.Scaling => code + " X0. Y0. Z0. P2000",
        Layer.Transform when meaning is NcMeaning.Mirroring => code + " X0.",
        Layer.Transform when meaning == NcMeaning.Polar => code,
        Layer.Transform => code + " X1. Y2.",
        Layer.Opaque when code == "CYCLE800" => "CYCLE800(0)",
        _ => code,
    };

    // CYCLDEF10SUB is the second line of CYCL DEF 10.
    private static string Spelled(string word)
    {
        var text = Regex.Replace(word, "^CYCLDEF(?<number>[0-9]+)(?<what>SUB|RESET)?$", m =>
            m.Groups["what"].Value switch
            {
                "SUB" => $"CYCL DEF {m.Groups["number"]}.1 X+1",
                "RESET" => m.Groups["number"].Value switch
                {
                    "10" => "CYCL DEF 10.1 ROT+0",
                    "11" => "CYCL DEF 11.1 SCL 1",
                    var n => $"CYCL DEF {n}.1",
                },
                _ => $"CYCL DEF {m.Groups["number"]}",
            }, RegexOptions.None, TimeSpan.FromSeconds(1));
        text = Regex.Replace(text, "^(?<word>PLANE|FUNCTION)(?=[A-Z])", "${word} ", RegexOptions.None, TimeSpan.FromSeconds(1));
        return text == "FUNCTION RESET" ? "FUNCTION RESET TCPM" : text;
    }
}
