using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Canned cycles, polar coordinates, probing, splines, feeds.</summary>
internal sealed class CyclePart(ProgramDraft draft, RandomNumbers random, MotionPart motions)
    : ProgramPart(draft, random)
{
    public void WriteCycles()
    {
        var scale = Draft.IsInch ? 25.4 : 1;
        var (third, first, second) = Draft.Plane switch
        {
            CoordinatePlane.ZX => ("Y", "Z", "X"),
            CoordinatePlane.YZ => ("X", "Y", "Z"),
            _ => ("Z", "X", "Y")
        };
        var plane = new[] { Grid(Uniform(-5, 5) / scale), Grid(Uniform(3, 9) / scale), Grid(Uniform(10, 30) / scale) };

        // Outside the plane XY the peer taps along the wrong axes.
        var code = Draft.Plane == CoordinatePlane.XY && Chance(0.1) ? "G84" : Any("G81", "G82", "G83", "G73", "G85", "G86", "G89");
        Draft.IsIncremental = Chance(0.3);

        // In increments R is from where the tool stands, the bottom from R.
        Block($"G90 G0 {third}{Number(Chance(0.2) ? plane[0] : plane[2])}");
        var heights = Draft.IsIncremental
            ? $"{third}{Number(-Grid(Uniform(3, 20) / scale))} R{Number(Grid(Uniform(-4, 4) / scale))}"
            : $"{third}{Number(Grid(plane[0] - (Uniform(3, 20) / scale)))} R{Number(plane[1])}";
        var words = code switch
        {
            "G82" or "G86" or "G89" => " P0.2",
            "G83" or "G73" => $" Q{Number(Grid(Uniform(1, 6) / scale))}",
            _ => "",
        };
        var repeats = Chance(0.2) ? $" L{1 + Below(3)}" : "";
        Block(
            $"{(Draft.IsIncremental ? "G91" : "G90")} {Any("G98", "G99")} {code} {first}{Number(Place())} {second}{Number(Place())} "
                + $"{heights}{words}{repeats}");
        for (var i = Below(4); i > 0; i--)
        {
            switch (Below(5))
            {
                case 0: Block($"{Any("G98", "G99")} {first}{Number(Place())}"); break;
                case 1: Block($"{second}{Number(Place())}"); break;
                default: Block($"{first}{Number(Place())} {second}{Number(Place())}{(Chance(0.2) ? " L2" : "")}"); break;
            }
        }

        Block("G80");
        Restate();
        Draft.Motion = "G0";

        double Place() => Draft.IsIncremental ? Grid(Uniform(-9, 9) / scale) : Length();
    }

    // Polar coordinates of the end, and holes on a circle.
    public void WritePolar()
    {
        ToPlaneXY();
        switch (Below(4))
        {
            case 0:
                Restate();
                Block($"{Any("G90", "G91")} {Any("G0", "G1")} {Any($"@{Radius()}", $"^{Angle()}", $"@{Radius()} ^{Angle()}")}");
                Restate();
                break;
            case 1:
                Restate();
                Block($"G90 G0 Z{Number(Grid(Uniform(20, 30) / (Draft.IsInch ? 25.4 : 1)))}");
                Block($"G91 {Any("G98", "G99")} G81 ^[360/{3 + Below(5)}] Z-1 R-0.5 L{1 + Below(5)}");
                Block("G80");
                Restate();
                break;
            default:
                motions.WriteMotion();
                break;
        }
    }

    // A wait beside a motion, a motion code that stands alone, a thread.
    public void WriteOddBlock()
    {
        switch (Below(5))
        {
            case 0:
                Restate();
                Block($"G4 P0.1 {Any("G0", "G1")} X{Number(Length())}");
                Restate();
                break;
            case 1:
                Block(Any("G0", "G1", "G00 G90"));
                Restate();
                break;
            case 2:
                Restate();
                Block($"G33 Z{Number(Length())} K0.1");
                Restate();
                break;
            default:
                motions.WriteMotion();
                break;
        }
    }

    public void WriteProbe()
    {
        if (Chance(0.3))
        {
            // The peer's probe trips at the end of the move, a little before it, so the place is said again.
            Block($"G90 {Any("G38.2", "G38.3", "G38.4", "G38.5")} Z{Number(Length() + (Draft.IsInch ? 5 : 100))}");
            Restate();
        }

        motions.WriteMotion();
    }

    public void WriteSpline()
    {
        if (Chance(0.4))
        {
            ToPlaneXY();
            Restate();
            var end = $"X{Number(Length())} Y{Number(Length())}";
            var pull = $"I{Number(Length())} J{Number(Length())}";
            Block(Chance(0.5) ? $"G5.1 {end} {pull}" : $"G5 {end} {pull} P{Number(Length())} Q{Number(Length())}");
            Block($"G1 Z{Number(Length())}");
            Restate();
        }

        motions.WriteMotion();
    }

    // Cycles, probing, and blocks that state no feed, are refused in other modes.
    public void FeedPerMinute()
    {
        if (Draft.FeedMode != "G94")
        {
            Draft.FeedMode = "G94";
            Block("G94 F" + Feed());
        }
    }

    public void WriteFeedMode()
    {
        if (Chance(0.3))
        {
            Draft.FeedMode = Any("G93", "G94", "G95");
            var isInverseTime = Draft.FeedMode == "G93";
            Block(isInverseTime ? Draft.FeedMode : $"{Draft.FeedMode} F{Feed()}");
            Draft.Motion = "";
            if (isInverseTime)
            {
                // The mode has no feed of its own: a cut states one.
                Block("G0 X0");
                Draft.At[0] = Draft.IsIncremental ? Draft.At[0] : 0;
            }
        }

        motions.WriteMotion();
    }

    private void ToPlaneXY()
    {
        if (Draft.Plane != CoordinatePlane.XY)
        {
            Draft.Plane = CoordinatePlane.XY;
            Block("G17");
        }
    }

    private string Radius() => Number(Math.Abs(Length()));

    private string Angle() => Number(Uniform(-200, 200));
}
