using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>LinuxCNC's line server, <c>linuxcncrsh</c>. The cell only reads, which needs no password.</summary>
/// <param name="Host">Name or address.</param>
/// <param name="Port">Its port.</param>
internal sealed record LinuxCncSettings(string Host, int Port) : StateSettings
{
    private const int UsualPort = 5007;

    /// <inheritdoc/>
    public override string Address => string.Create(CultureInfo.InvariantCulture, $"linuxcncrsh at {Host}:{Port}");

    public static LinuxCncSettings Read(JsonItem item) =>
        new(item["host"].Text, (int)(item.Find("port")?.Number ?? UsualPort));

    internal override MachineStateSource Open(TimeProvider clock) => new LinuxCnc(this);
}
