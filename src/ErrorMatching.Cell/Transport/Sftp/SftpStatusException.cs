using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>A request that an SFTP server refused.</summary>
/// <param name="code">The status.</param>
/// <param name="said">The server's own words.</param>
internal sealed class SftpStatusException(uint code, string said) : Exception(
    string.Create(CultureInfo.InvariantCulture, $"the server answered {code} ({(said.Length > 0 ? said : "no reason given")})"))
{
    /// <summary>The end of a file or of a folder's names.</summary>
    public const uint EndOfFile = 1;

    private const uint NoSuchFile = 2;
    private const uint PermissionDenied = 3;
    private const uint NoConnection = 6;
    private const uint ConnectionLost = 7;
    private const uint Unsupported = 8;

    /// <summary>The error, where the operation does not tell more.</summary>
    public TransportError Error => code switch
    {
        NoSuchFile or PermissionDenied or Unsupported => TransportError.Denied,
        NoConnection or ConnectionLost => TransportError.Away,
        _ => TransportError.Unknown,
    };

    /// <summary>True if the server gives no other reason than that it failed. Version 3 of the protocol has no code for a full disk, for
    /// example.</summary>
    public bool IsUnexplained => Error == TransportError.Unknown;
}
