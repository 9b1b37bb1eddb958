namespace ErrorMatching.Freeform.Tests;

/// <summary>Files as disks, networks and editors leave them.</summary>
internal static class Damaged
{
    /// <summary>One to three of: a byte changed, a piece taken out, doubled or moved, a number made absurd.</summary>
    public static byte[] Of(byte[] file, Random random)
    {
        var bytes = file.ToList();
        for (var times = 1 + random.Next(3); times > 0; times--)
        {
            var at = random.Next(bytes.Count - 20);
            var length = 1 + random.Next(12);
            switch (random.Next(5))
            {
                case 0:
                    bytes[at] = (byte)random.Next(256);
                    break;
                case 1:
                    bytes[at] = "0123456789.,;#()'$*-+E \n"u8[random.Next(24)];
                    break;
                case 2:
                    bytes.RemoveRange(at, length);
                    break;
                case 3:
                    bytes.InsertRange(random.Next(bytes.Count), bytes.GetRange(at, length));
                    break;
                default:
                    var digit = bytes.FindIndex(at, b => b is >= (byte)'0' and <= (byte)'9');
                    if (digit > 0 && digit + 4 < bytes.Count)
                    {
                        var absurd = random.Next(3) switch { 0 => "9E99"u8, 1 => "-1.0"u8, _ => "9999"u8 };
                        for (var i = 0; i < 4; i++)
                        {
                            bytes[digit + i] = absurd[i];
                        }
                    }

                    break;
            }
        }

        return [.. bytes];
    }
}
