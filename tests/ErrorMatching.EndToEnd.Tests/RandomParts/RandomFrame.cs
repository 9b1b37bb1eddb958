namespace ErrorMatching.EndToEnd.Tests;

/// <summary>From the part's frame to the program's: mirror (none; x: x to -x; y: y to -y), then rotation, then translation.</summary>
internal sealed record RandomFrame(string Mirror, double RotateDegrees, Flat Translate)
{
    public Flat ToProgram(Flat part)
    {
        var mirrored = Flip(part);
        var turned = Flat.Toward(RotateDegrees * Math.PI / 180);
        return (turned * mirrored.U) + (turned.Left * mirrored.V) + Translate;
    }

    public Flat ToPart(Flat program)
    {
        var turned = Flat.Toward(RotateDegrees * Math.PI / 180);
        var moved = program - Translate;
        return Flip(new(moved.Dot(turned), moved.Dot(turned.Left)));
    }

    private Flat Flip(Flat place) => new(Mirror == "x" ? -place.U : place.U, Mirror == "y" ? -place.V : place.V);
}
