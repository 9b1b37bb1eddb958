using System.Globalization;

namespace ErrorMatching.Peers.Tests;

/// <summary>Parameters, expressions, branches, loops, subprograms.</summary>
internal sealed class FlowPart(ProgramDraft draft, RandomNumbers random)
    : ProgramPart(draft, random)
{
    // The peer reads lines of up to 255 characters.
    private const int LongestLine = 200;

    public void WriteExpressions()
    {
        switch (Below(3))
        {
            case 0:
                Block(Any(
                    $"#1={Number(Length())} #2=[#1*2]",
                    $"#3=[{Expression(2)}]",
                    $"#<width>={Number(Length())}",
                    $"#<_shared_height>=[{Expression(1)}]",
                    "#[4+1]=#1",
                    "#1=5 #2=#1"));
                break;
            default:
                Draft.Motion = Any("G0", "G1");
                string x, y;
                do
                {
                    (x, y) = (Expression(2), Expression(1));
                }
                while (x.Length + y.Length > LongestLine);

                Block($"G90 {Draft.Motion} X[{x}] Y[{y}] Z{Number(Length())}");
                Draft.IsIncremental = false;
                break;
        }
    }

    // Values stay small: sums and products of bounded terms, functions of bounded arguments.
    private string Expression(int depth)
    {
        if (depth == 0)
        {
            return Any(Number(Length()), "#1", "#2", Number(1 + Below(9)), "-#1", "#[1+1]");
        }

        var (a, b) = (Expression(depth - 1), Expression(depth - 1));
        return Below(16) switch
        {
            0 => $"[{a}]+[{b}]",
            1 => $"[{a}]-[{b}]",
            2 => $"10*SIN[{a}]",
            3 => $"10*COS[{a}]",
            4 => $"ATAN[{a}]/[[{b}]+0.5]",
            5 => $"SQRT[ABS[{a}]]",
            6 => $"FIX[{a}]",
            7 => $"FUP[{a}]",
            8 => $"ROUND[{a}]",
            9 => $"[{a}] MOD 7",
            10 => $"[{a} GT {b}]*3",
            11 => $"[[{a}] LE [{b}]] + [[{a}] NE 0]",
            12 => "2**3-1",
            13 => $"[[{a}] AND [{b}]] + [[{a}] OR 0] + [[{a}] XOR 1]",
            14 => $"EXP[1]*LN[2.5]+ASIN[0.5]+TAN[40]",
            _ => $"[{a}]*2/[3+1]-[1+2]*3**2/4",
        };
    }

    public void WriteFlow()
    {
        var label = Draft.NextLabel();
        var counter = 20 + Below(10);
        switch (Below(6))
        {
            case 0:
                Line($"o{label} if [#1 GT {Number(Length())}]");
                Cut();
                Line($"o{label} elseif [#1 LT 0]");
                Cut();
                Line($"o{label} else");
                Cut();
                Line($"o{label} endif");
                break;
            case 1:
                Block($"#{counter}=0");
                Line($"o{label} while [#{counter} LT {1 + Below(4)}]");
                Cut($"#{counter}");
                Block($"#{counter}=[#{counter}+1]");
                Line($"o{label} endwhile");
                break;
            case 2:
                Block($"#{counter}=0");
                Line($"o{label} do");
                Cut($"#{counter}");
                Block($"#{counter}=[#{counter}+1]");
                Line($"o{label} while [#{counter} LT {1 + Below(4)}]");
                break;
            case 3:
                Line($"o{label} repeat [{Below(4)}]");
                Cut();
                Line($"o{label} endrepeat");
                break;
            case 4:
                Block($"#{counter}=0");
                Line($"O{label} WHILE [#{counter} LT 9]");
                Block($"#{counter}=[#{counter}+1]");
                Line($"o{label + 500} if [[#{counter} MOD 2] EQ 0]");
                Line($"o{label} continue");
                Line($"o{label + 500} endif");
                Line($"o{label + 600} if [#{counter} GT {2 + Below(6)}]");
                Line($"o{label} break");
                Line($"o{label + 600} endif");
                Cut($"#{counter}");
                Line($"o{label} endwhile");
                break;
            default:
                Block($"#1={Number(Length())}");
                break;
        }

        Restate();
    }

    public void WriteSubprogram()
    {
        var label = Draft.NextLabel();
        var name = Chance(0.3)
            ? string.Create(CultureInfo.InvariantCulture, $"<part{label}>")
            : label.ToString(CultureInfo.InvariantCulture);
        Line($"o{name} sub");
        Cut("#1");
        Block("#3=[#1+#2] #<own>=4");
        Cut("#3");
        if (Chance(0.5))
        {
            Line($"o{label + 500} if [#2 GT 0]");
            Line($"o{name} return{(Chance(0.5) ? " [#1*2]" : "")}");
            Line($"o{label + 500} endif");
        }

        Cut("#2");
        Line($"o{name} endsub{(Chance(0.5) ? " [#1+1]" : "")}");
        Block($"#1={Number(Length())}");
        for (var i = 1 + Below(2); i > 0; i--)
        {
            Line($"o{name} call [{Number(Length())}] [{Expression(1)}]");
            Cut("#1");
            Cut("#<_value>");
        }

        Restate();
    }

    private void Cut(string? value = null)
    {
        Draft.Motion = "G1";
        Draft.IsIncremental = false;
        Block(Below(3) switch
        {
            0 => $"G90 G1 X[{value ?? Number(Length())}+1] Y{Number(Length())}",
            1 => $"G91 G1 X{Number(Length())} Z[{value ?? Number(Length())}]",
            _ => $"G90 G0 {Any("X", "Y", "Z")}[{value ?? "2"}*0.5]",
        });
        Block("G90");
    }
}
