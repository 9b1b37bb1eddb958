using System.Text;

namespace ErrorMatching.Console;

/// <summary>Reads passwords from keys that are not echoed, or line by line from standard input. Never from arguments or the environment,
/// where other processes can read them.</summary>
/// <param name="input">Standard input; not accessed until a line is needed.</param>
/// <param name="readKey">Reads the next key; null if there is no keyboard.</param>
/// <param name="prompts">Receives the prompts.</param>
internal sealed class SecretInput(Lazy<TextReader> input, Func<ConsoleKeyInfo>? readKey, TextWriter prompts)
{
    /// <summary>Longer than any password.</summary>
    private const int MostCharacters = 4096;

    /// <summary>Reads passwords from an existing reader.</summary>
    public SecretInput(TextReader input, Func<ConsoleKeyInfo>? readKey, TextWriter prompts)
        : this(new Lazy<TextReader>(input), readKey, prompts)
    {
    }

    /// <summary>Prompts for a password.</summary>
    /// <param name="prompt">The prompt.</param>
    /// <param name="fromInput">True to read lines of standard input, one per password.</param>
    /// <exception cref="SecretInputException">No prompt is possible, or no input came.</exception>
    public string Ask(string prompt, bool fromInput)
    {
        if (fromInput && readKey is null)
        {
            return Line(prompt);
        }

        if (readKey is null)
        {
            throw new SecretInputException(
                $"There is no keyboard to ask for the {prompt}: standard input is redirected. Name --password-stdin to read passwords "
                    + $"from its lines.");
        }

        prompts.Write(char.ToUpperInvariant(prompt[0]) + prompt[1..] + ": ");
        var typed = Keys(readKey);
        prompts.Write("\n");
        return typed;
    }

    /// <summary>Prompts for a new password: twice at a keyboard, where typing errors are invisible.</summary>
    /// <exception cref="SecretInputException">As above, and if the two entries differ.</exception>
    public string AskNew(string prompt, bool fromInput)
    {
        var typed = Ask(prompt, fromInput);
        return readKey is null || Ask($"{prompt} again", fromInput) == typed
            ? typed
            : throw new SecretInputException($"The two differ: the {prompt} is not set.");
    }

    private string Line(string prompt)
    {
        var line = new StringBuilder();
        var next = input.Value.Read();
        var any = next >= 0;
        for (; next >= 0 && next != '\n'; next = input.Value.Read())
        {
            if (line.Length == MostCharacters)
            {
                throw new SecretInputException($"The line with the {prompt} is longer than any password.");
            }

            line.Append((char)next);
        }

        return any
            ? line.ToString().TrimEnd('\r')
            : throw new SecretInputException(
                $"Standard input ends before the {prompt}. It has one line for each password, in the order that --help names.");
    }

    private static string Keys(Func<ConsoleKeyInfo> readKey)
    {
        var typed = new StringBuilder();
        for (var key = readKey(); key.Key != ConsoleKey.Enter; key = readKey())
        {
            if (key.Key == ConsoleKey.Backspace)
            {
                typed.Length = Math.Max(0, typed.Length - 1);
            }
            else if (!char.IsControl(key.KeyChar) && typed.Length < MostCharacters)
            {
                typed.Append(key.KeyChar);
            }
        }

        return typed.ToString();
    }
}

/// <summary>A requested password could not be read.</summary>
internal sealed class SecretInputException(string message) : Exception(message);
