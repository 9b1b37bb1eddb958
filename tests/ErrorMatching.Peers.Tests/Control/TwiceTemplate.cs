namespace ErrorMatching.Peers.Tests;

/// <summary>A template of the shop for "job probe": each point is touched fast, left slowly, and touched again slowly from a few hundredths
/// of a millimeter. The log appears at once, when all points are touched.</summary>
internal static class TwiceTemplate
{
    /// <summary>Writes it into a folder, and returns its path.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="log">The log that its programs write.</param>
    public static string Write(string folder, string log)
    {
        var template = Path.Combine(folder, "twice.probing");
        File.WriteAllText(template, $$"""
            @about LinuxCNC, touches twice
            @body
            (probe {job})
            G21 G17 G40 G49 G90 G94 G54
            @if tool
            T{tool.number} M6
            @endif
            G0 Z{clearance.z}
            @each point
            (point {point}: {name})
            G0 X{approach.x} Y{approach.y}
            Z{approach.z}
            G38.2 X{overtravel.x} Y{overtravel.y} F300
            G38.4 X{approach.x} Y{approach.y} F60
            G38.2 X{overtravel.x} Y{overtravel.y} F6
            #10{point}=#5061
            #11{point}=#5062
            G0 X{approach.x} Y{approach.y}
            Z{clearance.z}
            @next
            (LOGOPEN,{{log}})
            (LOG,ERRORMATCH PROBE PLAN {plan} MM)
            @each point
            (LOG,P{point} C X#10{point} Y#11{point} Z{approach.z})
            @next
            (LOG,END)
            (LOGCLOSE)
            M2

            """);
        return template;
    }
}
