using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>The slot that the probe of the control touches, by its own file: how far a place is from its wall.</summary>
internal static class VirtualSlot
{
    private static readonly JsonElement Slot = JsonDocument.Parse(
        File.ReadAllBytes(Repository.PathTo("tests", "ErrorMatching.Peers.Tests", "Control", "slot.json"))).RootElement;

    /// <summary>Distance of a place from the wall in mm, positive inside the slot.</summary>
    public static double Room(double x, double y)
    {
        if (Math.Abs(x) <= Value("straightMm"))
            return Math.Min(OfFlank("top", x, y), OfFlank("bottom", x, y));
        var end = Slot.GetProperty(x < 0 ? "left" : "right");
        return Value(end, "radius") - Math.Sqrt(Math.Pow(x - Value(end, "x"), 2) + Math.Pow(y - Value(end, "y"), 2));
    }

    private static double OfFlank(string name, double x, double y)
    {
        var flank = Slot.GetProperty(name);
        var (sin, cos) = Math.SinCos(Value(flank, "degrees") * Math.PI / 180);
        var height = Value(flank, "y");
        return Math.Abs(height) - (Math.Sign(height) * ((y * cos) - (x * sin)));
    }

    private static double Value(string name) => Value(Slot, name);

    private static double Value(JsonElement item, string name) => item.GetProperty(name).GetDouble();
}
